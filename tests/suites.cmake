# Writes FILE, which adds one test for each suite of PROGRAM: a process a test would start 3,000 processes.
# cmake -DPROGRAM=… -DPREFIX=… -DLABEL=… -DCOST=… -DFILE=… -P suites.cmake
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE ";" "," listed "${listed}")
string(REPLACE "[" "(" listed "${listed}")  # a list of CMake keeps brackets together
string(REPLACE "]" ")" listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")

set(text "")
macro(end_of_suite)
  if(suite)
    math(EXPR cost "${count} * ${COST}")
    string(APPEND text "add_test([==[${PREFIX}${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==]"
                       " --gtest_brief=1)\n"
                       "set_tests_properties([==[${PREFIX}${suite}]==] PROPERTIES LABELS ${LABEL} TIMEOUT 900 COST ${cost})\n")
  endif()
endmacro()
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\.( |$)")
    end_of_suite()
    set(suite "${CMAKE_MATCH_1}")
    set(count 0)
  elseif(line MATCHES "^  ")
    math(EXPR count "${count} + 1")
  endif()
endforeach()
end_of_suite()
file(WRITE "${FILE}" "${text}")
