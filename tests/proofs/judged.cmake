# SPDX-License-Identifier: GPL-3.0-or-later
#   cmake -D CHECK=<seamproof-check> -D FILE=<certificate> -D STATUS=<exit status> -P judged.cmake
execute_process(COMMAND ${CHECK} ${FILE} RESULT_VARIABLE status OUTPUT_VARIABLE output)
if(NOT status EQUAL STATUS)
  message(FATAL_ERROR "exit status ${status}, expected ${STATUS}:\n${output}")
endif()
