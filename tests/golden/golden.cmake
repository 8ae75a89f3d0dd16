# SPDX-License-Identifier: GPL-3.0-or-later
# Verifies a paper and compares every file of its report with the committed one; then has the
# certificates judged by the independent checker.
#
#   cmake -D SEAMPROOF=… -D CHECK=… -D FILE=x.seam -D EXPECTED=reports/x -D ACTUAL=… -P golden.cmake
#
# Pictures are made of rounded samples, and are not committed. `./dev accept` writes the committed
# files again.
file(REMOVE_RECURSE ${ACTUAL})
execute_process(COMMAND ${SEAMPROOF} verify ${FILE} --out ${ACTUAL} --no-cache --quiet RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "seamproof: exit status ${status}")
endif()

file(GLOB_RECURSE expected RELATIVE ${EXPECTED} ${EXPECTED}/*)
file(GLOB_RECURSE actual RELATIVE ${ACTUAL} ${ACTUAL}/*)
list(FILTER expected EXCLUDE REGEX "\\.pdf$|\\.html$|^figures/")
list(FILTER actual EXCLUDE REGEX "\\.pdf$|\\.html$|^figures/")
set(different "")
foreach(name IN LISTS expected actual)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${EXPECTED}/${name} ${ACTUAL}/${name}
                  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(NOT status EQUAL 0)
    list(APPEND different ${name})
  endif()
endforeach()
if(different)
  list(REMOVE_DUPLICATES different)
  list(JOIN different "\n  " names)
  message(FATAL_ERROR "differ, or are on one side only (${EXPECTED}, ${ACTUAL}):\n  ${names}")
endif()

execute_process(COMMAND ${CHECK} ${ACTUAL} RESULT_VARIABLE status OUTPUT_QUIET)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "seamproof-check: exit status ${status}")
endif()
