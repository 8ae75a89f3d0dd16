# SPDX-License-Identifier: GPL-3.0-or-later
# seamproof_add_proofs(FILE.seam [ALLOW_UNDECIDED] [TIMEOUT SECONDS] [ARGS WORD...])
#
# A CTest test for each claim of the file, `<stem>.<id>`: it passes if the claim has its expected
# verdict. A claim that is undecided, or only conditional, against expectation fails, unless
# ALLOW_UNDECIDED. One more test, `<stem>`, verifies the file, once for all of them; it runs by
# itself before any of them, and fails if the file cannot be verified.
#
#   TIMEOUT  the seconds that the verification may take; CTest's own limit otherwise
#   ARGS     options of `seamproof verify`, such as --timeout 60 --effort 1000
#
# The claims are listed each time that ctest starts, so an edited file needs no new configuration.
# The program is the target seamproof::seamproof (find_package), seamproof (Seamproof's own build),
# or else the one on the PATH. The file needs no other: it may be copied into a project.
#
# It is read three times: by the project, which calls the function at the end; by ctest, for
# which _seamproof_list_tests adds the tests; and by each test, as a script that does a STEP.
cmake_policy(PUSH)
cmake_policy(VERSION 3.20)

# ---- In ctest: the tests of a file.

function(_seamproof_list_tests cmake program file stem folder allow_undecided timeout arguments)
  set(script "${CMAKE_CURRENT_FUNCTION_LIST_FILE}")
  set(fixture "seamproof ${file}")
  add_test("${stem}" "${cmake}" -D STEP=verify -D "PROGRAM=${program}" -D "FILE=${file}"
           -D "FOLDER=${folder}" -D "ARGUMENTS=${arguments}" -P "${script}")
  set_tests_properties("${stem}" PROPERTIES FIXTURES_SETUP "${fixture}")
  if(timeout)
    set_tests_properties("${stem}" PROPERTIES TIMEOUT "${timeout}")
  endif()

  # Where the file cannot be read there are no claims, and the test that verifies it says why.
  execute_process(COMMAND "${program}" list "${file}" OUTPUT_VARIABLE ids ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REPLACE "\n" ";" ids "${ids}")
  set(index 0)
  foreach(id IN LISTS ids)
    add_test("${stem}.${id}" "${cmake}" -D STEP=judge -D "ID=${id}" -D "INDEX=${index}"
             -D "FOLDER=${folder}" -D "ALLOW_UNDECIDED=${allow_undecided}" -P "${script}")
    set_tests_properties("${stem}.${id}" PROPERTIES FIXTURES_REQUIRED "${fixture}")
    math(EXPR index "${index} + 1")
  endforeach()
endfunction()

# ---- In a test: one step.

# 0 to 3 is said of claims, each of which has a test to say it.
function(_seamproof_verify)
  file(REMOVE_RECURSE "${FOLDER}")
  file(MAKE_DIRECTORY "${FOLDER}")
  execute_process(COMMAND "${PROGRAM}" verify "${FILE}" --json "${FOLDER}/results.json" ${ARGUMENTS}
                  RESULT_VARIABLE status)
  if(NOT status MATCHES "^[0-3]$" OR NOT EXISTS "${FOLDER}/results.json")
    message(FATAL_ERROR "not verified: ${PROGRAM} ended with ${status}")
  endif()
endfunction()

# A member of the claim; empty where there is none.
macro(_seamproof_get variable)
  string(JSON ${variable} ERROR_VARIABLE error GET "${claim}" ${variable})
  if(error)
    set(${variable} "")
  endif()
endmacro()

# As the exit status of the program: an alarm or a contradiction fails in any case.
function(_seamproof_judge)
  file(READ "${FOLDER}/results.json" results)
  string(JSON claim ERROR_VARIABLE absent GET "${results}" files 0 claims "${INDEX}")
  foreach(member id verdict expected as_expected corrected reason detail witness alarm corrected_alarm)
    _seamproof_get(${member})
  endforeach()
  if(absent OR NOT id STREQUAL "${ID}")
    message(FATAL_ERROR "the file was edited since ctest started: start it again")
  endif()

  message(NOTICE "${id}: ${verdict}, expected: ${expected}")
  foreach(member corrected reason detail witness alarm corrected_alarm)
    if(NOT "${${member}}" STREQUAL "")
      message(NOTICE "${member}: ${${member}}")
    endif()
  endforeach()

  if(NOT "${alarm}${corrected_alarm}" STREQUAL "")
    message(FATAL_ERROR "soundness alarm: the checker did not accept the evidence")
  elseif(as_expected)
    return()
  elseif(verdict MATCHES "^(proven|refuted)$" AND NOT verdict STREQUAL expected
         OR corrected STREQUAL "refuted")
    message(FATAL_ERROR "not as expected")
  elseif(NOT ALLOW_UNDECIDED)
    message(FATAL_ERROR "not decided")
  endif()
endfunction()

# ---- In the project.

function(seamproof_add_proofs file)
  cmake_parse_arguments(PARSE_ARGV 1 arg "ALLOW_UNDECIDED" "TIMEOUT" "ARGS")
  if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "seamproof_add_proofs(${file}): what is meant by "
                        "${arg_UNPARSED_ARGUMENTS}${arg_KEYWORDS_MISSING_VALUES}? "
                        "It takes ALLOW_UNDECIDED, TIMEOUT SECONDS, ARGS WORD...")
  endif()
  foreach(option IN LISTS arg_ARGS)
    if(option MATCHES "^--(claim|json)(=|$)")
      message(FATAL_ERROR "seamproof_add_proofs(${file}): ${option} cannot be in ARGS, for each "
                          "claim has a test, and reads its result")
    endif()
  endforeach()
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" NORMALIZE)
  if(NOT EXISTS "${file}")
    message(FATAL_ERROR "seamproof_add_proofs: there is no file ${file}")
  endif()
  cmake_path(GET file STEM LAST_ONLY stem)
  get_property(stems DIRECTORY PROPERTY _seamproof_stems)
  if(stem IN_LIST stems)
    message(FATAL_ERROR "seamproof_add_proofs(${file}): tests called ${stem} are there already; "
                        "files of one name go into different folders of the project")
  endif()
  set_property(DIRECTORY APPEND PROPERTY _seamproof_stems "${stem}")

  if(TARGET seamproof::seamproof)
    set(program "$<TARGET_FILE:seamproof::seamproof>")
  elseif(TARGET seamproof)
    set(program "$<TARGET_FILE:seamproof>")
  else()
    find_program(SEAMPROOF_PROGRAM seamproof)
    if(NOT SEAMPROOF_PROGRAM)
      message(FATAL_ERROR "seamproof_add_proofs(${file}): the program is not there: no target "
                          "seamproof::seamproof, and no seamproof on the PATH; "
                          "SEAMPROOF_PROGRAM may say where it is")
    endif()
    set(program "${SEAMPROOF_PROGRAM}")
  endif()

  # What a configuration of the build lists is written when the place of the program is known.
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/seamproof/${stem}")
  file(GENERATE OUTPUT "${folder}-$<CONFIG>.cmake" CONTENT
"include([==[${CMAKE_CURRENT_FUNCTION_LIST_FILE}]==])
_seamproof_list_tests([==[${CMAKE_COMMAND}]==] [==[${program}]==] [==[${file}]==]
  [==[${stem}]==] [==[${folder}]==] [==[${arg_ALLOW_UNDECIDED}]==] [==[${arg_TIMEOUT}]==] [==[${arg_ARGS}]==])
")
  get_property(is_multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
  if(is_multi_config)
    file(WRITE "${folder}.cmake" "include(\"${folder}-\${CTEST_CONFIGURATION_TYPE}.cmake\")\n")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${folder}.cmake")
  else()
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${folder}-${CMAKE_BUILD_TYPE}.cmake")
  endif()
endfunction()

if(CMAKE_SCRIPT_MODE_FILE AND STEP STREQUAL "verify")
  _seamproof_verify()
elseif(CMAKE_SCRIPT_MODE_FILE AND STEP STREQUAL "judge")
  _seamproof_judge()
endif()
cmake_policy(POP)
