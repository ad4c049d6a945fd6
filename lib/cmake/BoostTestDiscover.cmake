# boost_discover_tests(<target> [PREFIX <text>] [LABELS <labels>...])
#
# Registers every Boost.Test case of <target> with CTest, each as a test of its own named <PREFIX><suite>/<case>. The
# program lists its cases itself, each time it is linked; until then the test <target>_NOT_BUILT stands for them and
# fails. A program that lists no case is an error. The rows of a data-driven case stay one test.

set(boost_test_discover_file "${CMAKE_CURRENT_LIST_FILE}")

function(boost_discover_tests target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PREFIX" "LABELS")
  string(REPLACE ";" "," labels "${arg_LABELS}") # a list does not survive a command line
  set(listed "${CMAKE_CURRENT_BINARY_DIR}/${target}_tests.cmake")
  add_custom_command(
    TARGET ${target} POST_BUILD
    BYPRODUCTS "${listed}"
    COMMAND "${CMAKE_COMMAND}" "-DPROGRAM=$<TARGET_FILE:${target}>" "-DLISTED=${listed}" "-DPREFIX=${arg_PREFIX}"
            "-DLABELS=${labels}" -P "${boost_test_discover_file}"
    VERBATIM)
  file(CONFIGURE OUTPUT ${target}_include.cmake @ONLY CONTENT [[
if(EXISTS "@listed@")
  include("@listed@")
else()
  add_test(@target@_NOT_BUILT @target@_NOT_BUILT)
  set_tests_properties(@target@_NOT_BUILT PROPERTIES LABELS "@arg_LABELS@")
endif()
]])
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake")
endfunction()

# Appends to `script` the test whose path through the suites is in the list `path`.
macro(register_case)
  list(JOIN path "/" case)
  string(APPEND script "add_test([==[${PREFIX}${case}]==] [==[${PROGRAM}]==] [==[--run_test=${case}]==] "
                       "--color_output=no)\n"
                       "set_tests_properties([==[${PREFIX}${case}]==] PROPERTIES LABELS \"${labels}\")\n")
endmacro()

# Turns the indented list of suites and cases into CTest's commands. A line is a case if the next one is not deeper.
function(list_cases)
  execute_process(
    COMMAND "${PROGRAM}" --list_content --color_output=no
    OUTPUT_VARIABLE output
    ERROR_VARIABLE content # where Boost.Test prints it
    RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${PROGRAM} must list its cases, but --list_content ended with ${status}:\n${output}${content}")
  endif()

  string(REPLACE "," ";" labels "${LABELS}")
  string(REPLACE "\n" ";" lines "${output}${content}")
  set(script "")
  set(path "")
  set(last_depth -1)
  foreach(line IN LISTS lines)
    # Four blanks a level, the name, an asterisk if it is enabled, perhaps a description.
    if(NOT line MATCHES "^( *)([^ *:][^*:]*(::[^*:]+)*)")
      continue()
    endif()
    string(LENGTH "${CMAKE_MATCH_1}" indent)
    math(EXPR depth "${indent} / 4")
    string(STRIP "${CMAKE_MATCH_2}" name)
    if(name MATCHES "^_[0-9]+$") # a row
      continue()
    endif()
    if(depth LESS_EQUAL last_depth)
      register_case()
    endif()
    list(SUBLIST path 0 ${depth} path)
    list(APPEND path "${name}")
    set(last_depth ${depth})
  endforeach()
  if(NOT path)
    message(FATAL_ERROR "${PROGRAM} must hold at least one case, but --list_content names none:\n${output}${content}")
  endif()
  register_case()
  file(WRITE "${LISTED}" "${script}")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  list_cases()
endif()
