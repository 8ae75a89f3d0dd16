# SPDX-License-Identifier: GPL-3.0-or-later
# Read by CPack before it packs: the date of everything in a package is that of the changelog.
set(changelog ${CMAKE_CURRENT_LIST_DIR}/debian/changelog)
file(STRINGS ${changelog} first LIMIT_COUNT 1)
if(NOT first MATCHES "\\(${CPACK_PACKAGE_VERSION}\\)")
  message(FATAL_ERROR "${changelog} does not begin with version ${CPACK_PACKAGE_VERSION}: ${first}")
endif()
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  file(STRINGS ${changelog} date REGEX "^ -- .*  " LIMIT_COUNT 1)
  string(REGEX REPLACE "^ -- .*  " "" date "${date}")
  execute_process(COMMAND date --date "${date}" +%s OUTPUT_VARIABLE seconds
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(ENV{SOURCE_DATE_EPOCH} ${seconds})
endif()
