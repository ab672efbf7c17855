# Fails where a pattern of CASES, in GoogleTest's filter syntax, names no test case of PROGRAM: after
# a case is renamed, its pattern would silently select nothing.
string(REGEX REPLACE "[-:]" ";" patterns "${CASES}")
foreach(pattern IN LISTS patterns)
  if(pattern STREQUAL "")
    continue()
  endif()
  execute_process(COMMAND ${PROGRAM} --gtest_list_tests "--gtest_filter=${pattern}"
    OUTPUT_VARIABLE listed RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR NOT listed MATCHES "\n  ")
    message(SEND_ERROR "No test case is called ${pattern}")
  endif()
endforeach()
