# SPDX-License-Identifier: GPL-3.0-or-later
# seam_embed(<target> NAME <symbol> FILE <file>)
#
# The text of a file as a constant of the program: #include "embedded/<symbol>.h" gives
# seam::embedded::<symbol>. So a style sheet or a script lies beside the source that uses it, as a
# file that its own tools can read.
function(seam_embed target)
  cmake_parse_arguments(ARG "" "NAME;FILE" "" ${ARGN})
  cmake_path(ABSOLUTE_PATH ARG_FILE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARG_FILE})
  file(READ ${ARG_FILE} text)
  if(text MATCHES "\\)embedded\"")
    message(FATAL_ERROR "${ARG_FILE} holds the mark that ends an embedded text")
  endif()
  string(CONCAT header "#pragma once\n#include <string_view>\n"
         "namespace seam::embedded {\ninline constexpr std::string_view ${ARG_NAME} =\n"
         "R\"embedded(${text})embedded\";\n}\n")

  set(folder ${PROJECT_BINARY_DIR}/embedded_texts/${target})
  set(path ${folder}/embedded/${ARG_NAME}.h)
  set(before "")
  if(EXISTS ${path})
    file(READ ${path} before)
  endif()
  if(NOT before STREQUAL header)
    file(WRITE ${path} "${header}")
  endif()
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
