# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack` makes two Debian packages: seamproof, the programs, and libseamproof-dev, the libraries.
# Made twice from the same files, they are the same, byte by byte: prepare_debian.cmake says how.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME seamproof)
set(CPACK_PACKAGE_CONTACT "Seamproof developers <seamproof@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package_date.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/prepare_debian.cmake)

set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_DEB_COMPONENT_INSTALL TRUE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME seamproof)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "texlive-latex-recommended, texlive-pictures, lmodern")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "libseamproof-dev (= ${PROJECT_VERSION}), bash-completion")
set(CPACK_DEBIAN_PROGRAMS_DESCRIPTION "decides the claims of papers on smooth surfaces, exactly
The mathematics of a paper is written down in a text file: control nets,
curves, solids, and what the paper says of them. Of every claim Seamproof
says proven, refuted, conditional or undecided, with a certificate that a
second, much smaller program judges again. Nothing is decided by rounded
numbers.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libseamproof-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "seamproof (= ${PROJECT_VERSION}), pkg-config, nettle-dev, \
libflint-dev, libflint-arb-dev, libgmp-dev, libmpfr-dev, libginac-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "reads and judges certificates of Seamproof (development files)
Static libraries and headers for programs that read certificates of
Seamproof and judge them, or decide claims themselves; with files for CMake
and pkg-config.")
include(CPack)
