# The programs of an assignment, for the project beside this file and for the tests of the whole project.
#
# An assignment stands in chapters/<chNN_slug>/assignment: README.md, <noun>.hpp (the header to keep), <noun>.cpp (what
# is handed in, with holes), driver.cpp and check.cpp, if it is long in several check*.cpp. Its folder is found by its chapter.
get_filename_component(assignments_root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

# What the checks compare with: the topics of the library that check.cpp includes, and the sources of theirs that it needs.
set(assignment_topics_ch01 kinematics)
set(assignment_sources_ch01 kinematics/central_force)
set(assignment_topics_ch02 kinematics contact)
set(assignment_sources_ch02 contact/friction contact/impact)
set(assignment_topics_ch03 schemes)
set(assignment_sources_ch03 schemes/collocation schemes/collocation_table schemes/iteration schemes/mixing
    schemes/newton schemes/phi_control schemes/phi_family schemes/problem schemes/scales schemes/stage_solver schemes/state
    schemes/step_rates schemes/step_settings)
set(assignment_topics_ch04 kinematics)
set(assignment_sources_ch04 kinematics/cells kinematics/domain)
set(assignment_topics_ch05 identification)
set(assignment_sources_ch05 identification/mating)
set(assignment_topics_ch06 swarm)
set(assignment_sources_ch06 kinematics/particles schemes/state swarm/objective)
set(assignment_topics_ch07 thermo)
set(assignment_sources_ch07 thermo/cooling)
set(assignment_topics_ch08 continuum)
set(assignment_sources_ch08 continuum/equation_of_state)
set(assignment_topics_ch09 scattering)
set(assignment_sources_ch09 scattering/interface)

# assignment_library(<chNN> <variable>): the targets that hold what the check compares with. In the project's own build
# they are the topics; alone, a library of the few sources that are needed, which compiles in seconds.
function(assignment_library chapter variable)
  if(TARGET particulate::kinematics)
    list(TRANSFORM assignment_topics_${chapter} PREPEND particulate:: OUTPUT_VARIABLE targets)
  else()
    set(targets assignment_library_${chapter})
    if(NOT TARGET ${targets})
      find_package(Eigen3 3.4 REQUIRED NO_MODULE GLOBAL)
      find_package(fmt REQUIRED GLOBAL)
      list(TRANSFORM assignment_sources_${chapter} REPLACE "(.+)" "${assignments_root}/lib/particulate/\\1.cpp"
           OUTPUT_VARIABLE sources)
      add_library(${targets} STATIC EXCLUDE_FROM_ALL ${sources})
      # Headers take most of the time: they are read once.
      set_target_properties(${targets} PROPERTIES UNITY_BUILD ON)
      target_include_directories(${targets} PUBLIC "${assignments_root}/lib")
      target_link_libraries(${targets} PUBLIC Eigen3::Eigen fmt::fmt)
      target_compile_features(${targets} PUBLIC cxx_std_20)
    endif()
  endif()
  set(${variable} ${targets} PARENT_SCOPE)
endfunction()

# assignment_folder(<chNN> <folder> <noun>): sets these two variables for the caller.
function(assignment_folder chapter folder noun)
  file(GLOB found "${assignments_root}/chapters/${chapter}_*/assignment")
  file(GLOB header "${found}/*.hpp")
  list(LENGTH found folders)
  list(LENGTH header headers)
  if(NOT folders EQUAL 1 OR NOT headers EQUAL 1 OR NOT DEFINED assignment_topics_${chapter})
    file(GLOB all RELATIVE "${assignments_root}/chapters" "${assignments_root}/chapters/ch*_*/assignment")
    message(FATAL_ERROR "An assignment must be one of the folders ${all} below chapters, with one header and its "
                        "topics in assignment.cmake; given is '${chapter}'. Name one by its chapter, such as ch01.")
  endif()
  get_filename_component(name "${header}" NAME_WE)
  set(${folder} "${found}" PARENT_SCOPE)
  set(${noun} "${name}" PARENT_SCOPE)
endfunction()

# assignment_check(<chNN>): check_<chNN>, which grades, and driver_<chNN>, the main program around a submission.
function(assignment_check chapter)
  assignment_folder(${chapter} folder noun)
  assignment_library(${chapter} library)
  if(NOT TARGET assignment_grading)
    add_library(assignment_grading STATIC EXCLUDE_FROM_ALL "${assignments_root}/chapters/assignments/grading.cpp"
                "${assignments_root}/lib/particulate/report/guarded.cpp")
    target_include_directories(assignment_grading PUBLIC "${assignments_root}/chapters/assignments"
                               PRIVATE "${assignments_root}/lib")
    target_link_libraries(assignment_grading PUBLIC fmt::fmt)
    target_compile_features(assignment_grading PUBLIC cxx_std_20)
  endif()
  file(GLOB checks CONFIGURE_DEPENDS "${folder}/check*.cpp")
  add_executable(check_${chapter} EXCLUDE_FROM_ALL ${checks})
  target_link_libraries(check_${chapter} PRIVATE assignment_grading ${library})

  add_library(driver_${chapter} OBJECT EXCLUDE_FROM_ALL "${folder}/driver.cpp")
  target_include_directories(driver_${chapter} PUBLIC "${folder}"
                             PRIVATE "${assignments_root}/chapters/assignments")
  target_link_libraries(driver_${chapter} PUBLIC Eigen3::Eigen)
  target_compile_features(driver_${chapter} PUBLIC cxx_std_20)
endfunction()

# assignment_submission(<target> <chNN> <source>): what a student hands in, as a program that answers questions. It sees
# the header to keep and Eigen; the library it does not see.
function(assignment_submission target chapter source)
  add_executable(${target} EXCLUDE_FROM_ALL "${source}")
  target_link_libraries(${target} PRIVATE driver_${chapter})
endfunction()

# assignment_pack(<target> <archive> <options> <format> IN <folder> FILES <files> PARTS <folders> WITHOUT <paths>): a
# target that packs files of the project, which lose their folders, and folders of it, which keep them, into an archive; REVISION
# says which one of the project it is. <folder> is the one in the archive, or "." for its top.
function(assignment_pack target archive options format)
  cmake_parse_arguments(PARSE_ARGV 4 pack "" "IN" "FILES;PARTS;WITHOUT")
  set(stage "${CMAKE_CURRENT_BINARY_DIR}/${target}")
  set(inside "${stage}/${pack_IN}")
  set(commands "")
  foreach(part IN LISTS pack_PARTS)
    list(APPEND commands COMMAND ${CMAKE_COMMAND} -E copy_directory "${assignments_root}/${part}" "${inside}/${part}")
  endforeach()
  foreach(path IN LISTS pack_WITHOUT)
    list(APPEND commands COMMAND ${CMAKE_COMMAND} -E rm -rf "${inside}/${path}")
  endforeach()
  foreach(file IN LISTS pack_FILES)
    list(APPEND commands COMMAND ${CMAKE_COMMAND} -E copy "${assignments_root}/${file}" "${inside}")
  endforeach()
  set(revision "cd \"$1\" && cat REVISION || git describe --always --dirty --abbrev=40 || echo unknown")
  # What stands at the top is named, since a "." before each path is not looked through by every reader of a zip.
  set(pack "cd \"$1\" && \"$2\" -E tar $5 \"$3\" --format=$4 *")
  add_custom_target(
    ${target}
    COMMAND ${CMAKE_COMMAND} -E rm -rf "${stage}" "${archive}"
    COMMAND ${CMAKE_COMMAND} -E make_directory "${inside}"
    ${commands}
    COMMAND sh -c "(${revision}) 2>/dev/null >\"$2\"" revision "${assignments_root}" "${inside}/REVISION"
    COMMAND sh -c "${pack}" pack "${stage}" "${CMAKE_COMMAND}" "${archive}" ${format} ${options}
    COMMAND ${CMAKE_COMMAND} -E rm -rf "${stage}"
    COMMENT "Packed ${archive}"
    VERBATIM)
endfunction()

# assignment_archives(<chNN>): the targets handout_<chNN>, for students, and autograder_<chNN>, for Gradescope, where the
# two scripts must stand at the top. Both hold what the check is made of; neither holds tests or solutions.
function(assignment_archives chapter)
  assignment_folder(${chapter} folder noun)
  file(RELATIVE_PATH below "${assignments_root}" "${folder}")
  get_filename_component(shown "${below}" DIRECTORY)
  set(own chapters/assignments)
  set(handout "particulate_${chapter}")
  assignment_pack(
    handout_${chapter} "${CMAKE_CURRENT_BINARY_DIR}/${handout}.tar.gz" czf gnutar IN ${handout}
    FILES LICENSE ${own}/handout/README.md PARTS lib ${own} ${shown}
    WITHOUT ${own}/autograder ${own}/handout ${own}/grade.sh)
  assignment_pack(
    autograder_${chapter} "${CMAKE_CURRENT_BINARY_DIR}/autograder_${chapter}.zip" cf zip IN .
    FILES LICENSE ${own}/autograder/setup.sh ${own}/autograder/run_autograder PARTS lib ${own} ${below}
    WITHOUT ${own}/autograder ${own}/handout ${own}/grade.sh)
endfunction()
