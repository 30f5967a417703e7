# SPDX-License-Identifier: BSD-3-Clause
# catkin's run_tests runs only rostests; this adds all other tests of ctest and builds their programs.
function(mbncc_depend_on_programs target folder)
  get_property(programs DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(program ${programs})
    get_target_property(type ${program} TYPE)
    if(type MATCHES "^(EXECUTABLE|SHARED_LIBRARY|MODULE_LIBRARY)$")
      add_dependencies(${target} ${program})
    endif()
  endforeach()
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder ${subfolders})
    mbncc_depend_on_programs(${target} ${subfolder})
  endforeach()
endfunction()

if(TARGET run_tests_${PROJECT_NAME})
  add_custom_target(run_tests_${PROJECT_NAME}_plain
    COMMAND ${CATKIN_ENV} ${CMAKE_CTEST_COMMAND} --output-on-failure -E ^_ctest_
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR} VERBATIM)
  mbncc_depend_on_programs(run_tests_${PROJECT_NAME}_plain ${PROJECT_SOURCE_DIR})
  foreach(all run_tests_${PROJECT_NAME} _run_tests_${PROJECT_NAME})
    add_dependencies(${all} run_tests_${PROJECT_NAME}_plain)
  endforeach()
  if(CMAKE_GENERATOR STREQUAL "Unix Makefiles")
    add_test(NAME run_tests
      COMMAND grep "_run_tests_${PROJECT_NAME}.dir/all: .*/run_tests_${PROJECT_NAME}_plain.dir/all"
              ${CMAKE_BINARY_DIR}/CMakeFiles/Makefile2)
  endif()
endif()
