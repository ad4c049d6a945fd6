# Builds this folder as a project of its own against the library, as someone else would, and runs what came out.
#
#   cmake -DVARIANT=... -DSOURCE=<project> -DBUILD=<its build tree> -DWORK=<scratch> -DARGUMENTS=<for configuring>
#         -P check.cmake
#
# Whatever the variant, the consumer may find Eigen and fmt and nothing else, but for what a library that was built with
# threads needs of OpenMP; where it is compiled anew it is built without.

cmake_minimum_required(VERSION 3.25)

set(forbidden SUNDIALS Boost CLI11 tomlplusplus nlohmann_json benchmark OpenMP Doxygen)
if(NOT VARIANT STREQUAL "subproject")
  list(REMOVE_ITEM forbidden OpenMP)
endif()
list(TRANSFORM forbidden REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON" OUTPUT_VARIABLE nothing_else)
set(consumer "${CMAKE_CURRENT_LIST_DIR}")
# Where the library is compiled anew, what counts is that it can be: unoptimized, and a topic at a time.
set(hasty -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_UNITY_BUILD=ON
    -DCMAKE_UNITY_BUILD_BATCH_SIZE=100)

# run(<what> <command>...): its output in `output`; anything but success ends the test.
function(run what)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} must succeed, but ended with ${status}:\n${output}")
  endif()
  message(STATUS "${what}: done")
  set(output "${output}" PARENT_SCOPE)
endfunction()

# refuse(<what> <words> <command>...): it must fail and say these words, apart from where CMake breaks its lines.
function(refuse what words)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(status EQUAL 0)
    message(FATAL_ERROR "${what} must fail, but succeeded:\n${output}")
  endif()
  string(REGEX REPLACE "[ \n]+" " " said "${output}")
  string(FIND "${said}" "${words}" position)
  if(position EQUAL -1)
    message(FATAL_ERROR "${what} must fail saying \"${words}\", but said:\n${output}")
  endif()
  message(STATUS "${what}: refused, as it must be")
endfunction()

# use(<folder of the package> <further arguments>...): configures, builds and runs the consumer.
function(use package)
  run("Configuring the consumer" "${CMAKE_COMMAND}" -S "${consumer}" -B "${WORK}/consumer" ${ARGUMENTS}
      ${nothing_else} "-Dparticulate_DIR=${package}" ${ARGN})
  run_programs("${WORK}/consumer")
endfunction()

# run_programs(<build tree>): builds it and runs one program for each source here, at least the one that is known.
function(run_programs tree)
  run("Building the consumer" "${CMAKE_COMMAND}" --build "${tree}")
  file(GLOB sources "${consumer}/*.cpp")
  if(NOT "${consumer}/two_particles.cpp" IN_LIST sources)
    message(FATAL_ERROR "${consumer} must hold two_particles.cpp, but holds: ${sources}")
  endif()
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM name)
    run("Running ${name}" "${tree}/${name}")
    message(STATUS "  ${output}")
    if(output STREQUAL "" OR (name STREQUAL "two_particles" AND NOT output MATCHES "distance 0\\.3333333"))
      message(FATAL_ERROR "${name} must print its result (two_particles: a third), but printed: '${output}'")
    endif()
  endforeach()
endfunction()

# ask_for(<words of the refusal> <components> <further arguments>...): asks the package in ${package} for components.
function(ask_for words components)
  file(CONFIGURE OUTPUT "${WORK}/ask/CMakeLists.txt" @ONLY CONTENT [[
cmake_minimum_required(VERSION 3.25)
project(ask LANGUAGES CXX)
find_package(particulate REQUIRED COMPONENTS @components@)
]])
  refuse("Asking for ${components}" "${words}" "${CMAKE_COMMAND}" -S "${WORK}/ask" -B "${WORK}/ask/build" ${ARGUMENTS}
         "-Dparticulate_DIR=${package}" ${ARGN})
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

if(VARIANT STREQUAL "build_tree")
  set(package "${BUILD}/cmake/particulate")
  use("${package}")
  ask_for("component 'plasma' must be one that was built, and this package holds: kinematics, schemes" plasma)
  ask_for("SUNDIALS" reference -DCMAKE_DISABLE_FIND_PACKAGE_SUNDIALS=ON)
elseif(VARIANT STREQUAL "install_tree")
  run("Installing" "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/made")
  file(RENAME "${WORK}/made" "${WORK}/moved") # an installation can be carried elsewhere
  file(GLOB_RECURSE package "${WORK}/moved/particulate-config.cmake")
  cmake_path(GET package PARENT_PATH package)
  use("${package}")
elseif(VARIANT STREQUAL "subproject")
  # The physics can be configured for itself. It is compiled below, as a part of someone else's project, once for both.
  run("Configuring the physics alone" "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/alone" ${ARGUMENTS} ${nothing_else}
      -DPARTICULATE_REFERENCE=OFF -DPARTICULATE_REPORT=OFF -DPARTICULATE_PROGRAMS=OFF)
  # The parent's own warnings are errors; the library's sources must not be drawn into that by the library itself.
  file(CONFIGURE OUTPUT "${WORK}/CMakeLists.txt" @ONLY CONTENT [[
cmake_minimum_required(VERSION 3.25)
project(parent LANGUAGES CXX)
add_subdirectory("@SOURCE@" particulate)
get_target_property(options particulate_contact COMPILE_OPTIONS)
if(options MATCHES "-W|-march" OR TARGET particulate_report OR TARGET particulate_reference OR TARGET unit_tests)
  message(FATAL_ERROR "a project that adds this one must get the physics alone, without its warnings: ${options}")
endif()
file(GLOB sources "@consumer@/*.cpp")
foreach(source IN LISTS sources)
  cmake_path(GET source STEM name)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE particulate::contact particulate::schemes particulate::scenes)
  target_compile_options(${name} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
endforeach()
]])
  run("Configuring the parent" "${CMAKE_COMMAND}" -S "${WORK}" -B "${WORK}/build" ${ARGUMENTS} ${hasty}
      ${nothing_else})
  run_programs("${WORK}/build")
  # What was compiled is the physics alone: installed, it serves others like any installation.
  run("Installing the physics alone" "${CMAKE_COMMAND}" --install "${WORK}/build" --prefix "${WORK}/prefix")
  file(GLOB_RECURSE package "${WORK}/prefix/particulate-config.cmake")
  cmake_path(GET package PARENT_PATH package)
  use("${package}")
  ask_for("component 'reference' must be one that was built" reference)
else()
  message(FATAL_ERROR "VARIANT must be build_tree, install_tree or subproject, got '${VARIANT}'")
endif()
