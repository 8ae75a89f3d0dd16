# SPDX-License-Identifier: GPL-3.0-or-later
# What the layout promises and no compiler checks.
#
#   cmake -D ROOT=<the project> -P layout.cmake
cmake_minimum_required(VERSION 3.25)
set(failures "")

function(fail message)
  list(APPEND failures "${message}")
  set(failures "${failures}" PARENT_SCOPE)
endfunction()

# The lines of a file that match, as `found`.
function(grep file regex)
  file(STRINGS ${file} found REGEX "${regex}")
  set(found "${found}" PARENT_SCOPE)
endfunction()

# The number of lines of a file, as `length`; with CODE, of those that are more than a remark.
function(count_lines file)
  file(READ ${file} content)
  if(ARGN STREQUAL "CODE")
    string(REGEX REPLACE "\n( *(//[^\n]*)?\n)+" "\n" content "\n${content}")
  endif()
  string(REGEX MATCHALL "\n" ends "${content}")
  list(LENGTH ends length)
  set(length ${length} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/src/*.h ${ROOT}/src/*.cpp)
file(GLOB_RECURSE tests RELATIVE ${ROOT} ${ROOT}/tests/*.h ${ROOT}/tests/*.cpp)
file(GLOB_RECURSE scripts RELATIVE ${ROOT} ${ROOT}/src/CMakeLists.txt ${ROOT}/tests/CMakeLists.txt
     ${ROOT}/cmake/*.cmake ${ROOT}/tests/*.cmake ${ROOT}/tests/second_checker/*.py)
if(NOT sources)
  fail("no sources below ${ROOT}/src")
endif()

# A library is included only in the room that it is for.
set(rooms
  "flint/|arb|fmp|acb|gmp|mpfr|e-antic"  "exact"
  "ginac|cln"                            "symbolic"
  "boost/"                               "check"
  "nlohmann"                             "certificate|report"
  "nettle"                               "certificate"
  "tao/"                                 "claims"
  "CLI"                                  "cli")
while(rooms)
  list(POP_FRONT rooms library room)
  foreach(file IN LISTS sources)
    grep(${ROOT}/${file} "^#include <(${library})")
    if(found AND NOT file MATCHES "^src/(${room})/")
      fail("${file}: belongs in src/${room}: ${found}")
    endif()
  endforeach()
endwhile()

foreach(file IN LISTS sources tests scripts)
  count_lines(${ROOT}/${file})
  if(file MATCHES "\\.(h|cpp)$" AND length GREATER 400)
    fail("${file}: ${length} lines are too many")
  endif()

  set(licence "GPL-3.0-or-later")
  if(file MATCHES "^(src|tests)/(text|certificate|check)/.*\\.(h|cpp)$")
    set(licence "GPL-3.0-or-later OR BSL-1.0")
  endif()
  file(STRINGS ${ROOT}/${file} first LIMIT_COUNT 1)
  if(NOT first MATCHES "^(//|#) SPDX-License-Identifier: ${licence}$")
    fail("${file}: the first line is not 'SPDX-License-Identifier: ${licence}'")
  endif()

  grep(${ROOT}/${file} "^#include \"\\.\\./")
  if(found)
    fail("${file}: an include climbs out of its module: ${found}")
  endif()
  if(file MATCHES "(utils?|common|core|helpers?|manager|misc|impl2?)(/|\\.h$|\\.cpp$)")
    fail("${file}: a name that says nothing")
  endif()
endforeach()

# No paper is known to the program: what it can do, it can do for every file.
foreach(file IN LISTS sources)
  file(READ ${ROOT}/${file} content)
  string(TOLOWER "${content}" content)
  if(content MATCHES "(tetroid|cuboid|octoid|dodecoid|icosoid|spheroid)")
    fail("${file}: names a paper or a surface of one: ${CMAKE_MATCH_1}")
  endif()
endforeach()

# The checker is apart from everything else, and short enough to be read in an evening.
file(STRINGS ${ROOT}/src/check/CMakeLists.txt depends REGEX "seam_module")
if(NOT depends MATCHES "^seam_module\\(check DEPENDS text certificate( PRIVATE_LIBS [A-Za-z:]+)?\\)$")
  fail("src/check/CMakeLists.txt: the checker uses text and certificate alone, but: ${depends}")
endif()

# docs/trust.md says how many lines of code there are at most of what has to be believed.
file(STRINGS ${ROOT}/docs/trust.md rows REGEX "^\\| `src/")
set(counted "")
foreach(row IN LISTS rows)
  string(REGEX MATCH "\\| ([0-9,]+) \\|" matched "${row}")
  string(REPLACE "," "" budget "${CMAKE_MATCH_1}")
  string(REGEX MATCHALL "src/[a-z]+" folders "${row}")
  set(total 0)
  foreach(file IN LISTS sources)
    string(REGEX MATCH "^src/[a-z]+" folder ${file})
    if(folder IN_LIST folders)
      count_lines(${ROOT}/${file} CODE)
      math(EXPR total "${total} + ${length}")
    endif()
  endforeach()
  list(JOIN folders ", " names)
  if(NOT budget OR total GREATER budget)
    fail("${names}: ${total} lines of code, more than the ${budget} of docs/trust.md")
  endif()
  string(APPEND counted "${names}: ${total} of ${budget} lines of code\n")
endforeach()
if(NOT counted MATCHES "src/check")
  fail("docs/trust.md does not say how many lines of code src/check has")
endif()

if(failures)
  list(JOIN failures "\n" message)
  message(FATAL_ERROR "${message}")
endif()
message(STATUS "${counted}")
