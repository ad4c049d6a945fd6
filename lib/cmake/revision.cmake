# Writes what a stamp says of a build into a header, at build time, and only if it changed: a build without news
# compiles nothing. Run by `cmake -P` with SOURCE (the project), OUTPUT (the header), COMPILER, FLAGS and BUILD_TYPE.

# git's answer in <out>, and whether it gave one in <out>_found.
function(ask_git out)
  execute_process(
    COMMAND git -C "${SOURCE}" ${ARGN}
    RESULT_VARIABLE status
    OUTPUT_VARIABLE answer
    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${out} "${answer}" PARENT_SCOPE)
  if(status EQUAL 0)
    set(${out}_found TRUE PARENT_SCOPE)
  else()
    set(${out}_found FALSE PARENT_SCOPE)
  endif()
endfunction()

# A copy of this project inside another one's repository must not take the other's revision for its own.
set(revision "unknown")
ask_git(prefix rev-parse --show-prefix)
ask_git(commit rev-parse --verify HEAD)
if(prefix_found AND commit_found AND prefix STREQUAL "")
  set(revision "${commit}")
  ask_git(changes status --porcelain)
  if(NOT changes_found OR NOT changes STREQUAL "")
    string(APPEND revision "-dirty")
  endif()
endif()

foreach(fact IN ITEMS COMPILER FLAGS BUILD_TYPE)
  string(STRIP "${${fact}}" text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" ${fact} "${text}")
endforeach()

file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT [[
#pragma once

namespace particulate::report::build_facts {

inline constexpr const char* revision = "@revision@";
inline constexpr const char* compiler = "@COMPILER@";
inline constexpr const char* flags = "@FLAGS@";
inline constexpr const char* build_type = "@BUILD_TYPE@";

}  // namespace particulate::report::build_facts
]])
