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

# assignment_autograder(<chNN>): the target autograder_<chNN>, which packs autograder_<chNN>.zip for Gradescope. It
# holds what the check is made of and nothing else; the two scripts stand at its top, where Gradescope looks for them.
function(assignment_autograder chapter)
  assignment_folder(${chapter} folder noun)
  file(RELATIVE_PATH below "${assignments_root}" "${folder}")
  set(stage "${CMAKE_CURRENT_BINARY_DIR}/autograder_${chapter}")
  set(copies "")
  foreach(part IN ITEMS lib chapters/assignments ${below})
    list(APPEND copies COMMAND ${CMAKE_COMMAND} -E copy_directory "${assignments_root}/${part}" "${stage}/${part}")
  endforeach()
  foreach(part IN ITEMS LICENSE chapters/assignments/autograder/setup.sh
                        chapters/assignments/autograder/run_autograder)
    list(APPEND copies COMMAND ${CMAKE_COMMAND} -E copy "${assignments_root}/${part}" "${stage}")
  endforeach()
  add_custom_target(
    autograder_${chapter}
    COMMAND ${CMAKE_COMMAND} -E rm -rf "${stage}" "${stage}.zip"
    COMMAND ${CMAKE_COMMAND} -E make_directory "${stage}"
    ${copies}
    COMMAND ${CMAKE_COMMAND} -E rm -rf "${stage}/chapters/assignments/autograder"
    COMMAND ${CMAKE_COMMAND} -E chdir "${stage}" ${CMAKE_COMMAND} -E tar cf "${stage}.zip" --format=zip
            setup.sh run_autograder LICENSE lib chapters
    COMMAND ${CMAKE_COMMAND} -E rm -rf "${stage}"
    COMMENT "Autograder ${stage}.zip"
    VERBATIM)
endfunction()
