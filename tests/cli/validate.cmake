# SPDX-License-Identifier: GPL-3.0-or-later
# What CI systems read is what their formats ask for, for files with claims of every kind and for a
# file with errors: JUnit XML by its schema, SARIF by the validator of its makers.
#
#   cmake -D SEAMPROOF=… -D XMLLINT=… -D SCHEMA=junit.xsd -D MULTITOOL=… -D FOLDER=… -P validate.cmake
#
# XMLLINT or MULTITOOL may be missing: the other is looked at.
file(REMOVE_RECURSE ${FOLDER})
file(WRITE ${FOLDER}/claims.seam [=[
claim right: 1 + 1 = 2
claim wrong "hostile ]]> <&\"' ::error::%0A": 1 + 1 = 3
claim open: for all x: exp(x) >= 1 + x
claim erratum: 2 = 3
    corrected: 2 = 2
table t "a table" for k in 1..2: "row" k ~ 1, 3
]=])
file(WRITE "${FOLDER}/with blank/broken.seam" "claim a: 1 + = 3\nclaim b: x = 1\n")
set(ENV{DOTNET_SYSTEM_GLOBALIZATION_INVARIANT} 1)

function(validate name file)
  set(outputs --junit ${FOLDER}/${name}.xml --sarif ${FOLDER}/${name}.sarif)
  execute_process(COMMAND ${SEAMPROOF} verify ${file} --quiet ${outputs} ${ARGN}
                  WORKING_DIRECTORY ${FOLDER} OUTPUT_QUIET ERROR_QUIET)
  if(XMLLINT)
    execute_process(COMMAND ${XMLLINT} --noout --schema ${SCHEMA} ${FOLDER}/${name}.xml
                    RESULT_VARIABLE status ERROR_VARIABLE output OUTPUT_VARIABLE output)
    if(status)
      message(SEND_ERROR "JUnit of ${file}:\n${output}")
    endif()
  endif()
  if(MULTITOOL)
    execute_process(COMMAND ${MULTITOOL} validate ${FOLDER}/${name}.sarif
                    RESULT_VARIABLE status ERROR_VARIABLE output OUTPUT_VARIABLE output)
    if(status OR output MATCHES ": error " OR NOT output MATCHES "1 files scanned")
      message(SEND_ERROR "SARIF of ${file}:\n${output}")
    endif()
  endif()
endfunction()

validate(claims claims.seam)
validate(allowed claims.seam --allow-undecided)
validate(broken "with blank/broken.seam")
