# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where. Two components: `programs`, for who verifies papers, and
# `development`, for who writes programs that read certificates or decide statements.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The libraries in two parts: the checker alone needs little, the prover GiNaC, FLINT and Arb.
set(check_modules text certificate check)
set(prover_modules exact symbolic bernstein geometry claims prove)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/seamproof)

install(TARGETS seamproof seamproof-check EXPORT seamproof-programs
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT programs)
foreach(part check prover)
  list(TRANSFORM ${part}_modules PREPEND seam_ OUTPUT_VARIABLE targets)
  install(TARGETS ${targets} EXPORT seamproof-${part}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()

install(CODE "set(work \"${PROJECT_BINARY_DIR}/install/include\")
set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/seamproof\")" COMPONENT development)
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/install_headers.cmake COMPONENT development)

# The CMake package.
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/seamproofConfig.cmake.in
  ${PROJECT_BINARY_DIR}/install/seamproofConfig.cmake INSTALL_DESTINATION ${package_folder}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/install/seamproofConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/install/seamproofConfig.cmake
              ${PROJECT_BINARY_DIR}/install/seamproofConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT programs)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/SeamproofAddProofs.cmake
        DESTINATION ${package_folder} COMPONENT programs)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/FindFLINT.cmake
        DESTINATION ${package_folder} COMPONENT development)
install(EXPORT seamproof-programs NAMESPACE seamproof:: DESTINATION ${package_folder} COMPONENT programs)
foreach(part check prover)
  install(EXPORT seamproof-${part} NAMESPACE seamproof:: DESTINATION ${package_folder}
          COMPONENT development)
endforeach()

# pkg-config: paths relative to where the file lies, so that the prefix can be moved.
file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" up "${up}")
cmake_path(GET FLINT_ARB_LIBRARY STEM arb)
string(REGEX REPLACE "^lib" "-l" arb "${arb}")
foreach(part check prover)
  # Who needs a library stands before it.
  list(REVERSE ${part}_modules)
  list(TRANSFORM ${part}_modules PREPEND "-lseamproof_" OUTPUT_VARIABLE libraries)
  list(JOIN libraries " " libraries)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/seamproof-${part}.pc.in
                 ${PROJECT_BINARY_DIR}/install/seamproof-${part}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/install/seamproof-${part}.pc
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endforeach()

# Manual pages, and completion under the names by which the shells look for it.
install(FILES ${PROJECT_BINARY_DIR}/src/cli/seamproof.1 src/cli/manual/seamproof-check.1
        DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
foreach(program seamproof seamproof-check)
  install(FILES src/cli/completion/${program}.bash RENAME ${program}
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT programs)
  install(FILES src/cli/completion/${program}.fish
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT programs)
endforeach()
install(FILES src/cli/completion/_seamproof
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT programs)

# The style of reports, for papers: TeX looks for it here.
install(FILES src/report/seamproof.sty
        DESTINATION ${CMAKE_INSTALL_DATADIR}/texmf/tex/latex/seamproof COMPONENT programs)

# The extension for VS Code.
install(DIRECTORY src/claims/vscode DESTINATION ${CMAKE_INSTALL_DATADIR}/seamproof COMPONENT programs)

# To read: the documents as they lie here, so that their links hold, and the papers as examples.
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
install(FILES LICENSE TYPE DOC COMPONENT programs)
install(DIRECTORY docs LICENSES proofs TYPE DOC COMPONENT programs)
