# SPDX-License-Identifier: GPL-3.0-or-later
# Finds FLINT 2 and Arb, which bring no CMake or pkg-config files: the targets FLINT::flint and
# FLINT::arb. Arb's library is called flint-arb on Debian and arb elsewhere.
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_path(FLINT_ARB_INCLUDE_DIR arb.h)
find_library(FLINT_LIBRARY flint)
find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_ARB_INCLUDE_DIR FLINT_LIBRARY FLINT_ARB_LIBRARY)

if(FLINT_INCLUDE_DIR)
  file(STRINGS ${FLINT_INCLUDE_DIR}/flint/flint.h FLINT_VERSION REGEX "^#define FLINT_VERSION ")
  string(REGEX MATCH "[0-9.]+" FLINT_VERSION "${FLINT_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT
  REQUIRED_VARS FLINT_LIBRARY FLINT_ARB_LIBRARY FLINT_INCLUDE_DIR FLINT_ARB_INCLUDE_DIR
  VERSION_VAR FLINT_VERSION
  REASON_FAILURE_MESSAGE "FLINT 2 and Arb are needed (Debian: libflint-dev libflint-arb-dev)")

if(FLINT_FOUND AND NOT TARGET FLINT::flint)
  add_library(FLINT::flint UNKNOWN IMPORTED)
  set_target_properties(FLINT::flint PROPERTIES IMPORTED_LOCATION ${FLINT_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${FLINT_INCLUDE_DIR})
endif()
if(FLINT_FOUND AND NOT TARGET FLINT::arb)
  add_library(FLINT::arb UNKNOWN IMPORTED)
  set_target_properties(FLINT::arb PROPERTIES IMPORTED_LOCATION ${FLINT_ARB_LIBRARY}
                        INTERFACE_INCLUDE_DIRECTORIES ${FLINT_ARB_INCLUDE_DIR}
                        INTERFACE_LINK_LIBRARIES FLINT::flint)
endif()
