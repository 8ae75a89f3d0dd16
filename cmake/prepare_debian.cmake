# SPDX-License-Identifier: GPL-3.0-or-later
# Run by CPack on the installed files of each component, before they are packed: what Debian wants
# otherwise than others, and what makes packages the same when made again: no times, names or
# permissions of this machine.
set(debian ${CMAKE_CURRENT_LIST_DIR}/debian)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
  string(TOUPPER ${component} upper)
  set(doc ${root}/usr/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})

  file(MAKE_DIRECTORY ${doc})
  file(COPY_FILE ${debian}/copyright ${doc}/copyright)
  file(REMOVE_RECURSE ${doc}/LICENSE ${doc}/LICENSES)
  file(COPY_FILE ${debian}/changelog ${doc}/changelog)
  file(GLOB pages ${root}/usr/share/man/man1/*)
  execute_process(COMMAND gzip --best --no-name --force ${doc}/changelog ${pages}
                  COMMAND_ERROR_IS_FATAL ANY)
  if(EXISTS ${root}/usr/share/zsh/site-functions)
    file(RENAME ${root}/usr/share/zsh/site-functions ${root}/usr/share/zsh/vendor-completions)
  endif()

  file(GLOB libraries ${root}/usr/lib/*.a)
  if(libraries)
    execute_process(COMMAND strip --strip-debug --enable-deterministic-archives ${libraries}
                    COMMAND_ERROR_IS_FATAL ANY)
  endif()

  execute_process(COMMAND chmod -R go-w,a+rX ${root} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND find ${root} -exec touch --no-dereference --date @$ENV{SOURCE_DATE_EPOCH} {} +
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
