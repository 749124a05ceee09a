# Grading students' folders, with every kind of student. Included by CMakeLists.txt here.

find_program(TEXMAP_SH sh)
find_program(TEXMAP_TIMEOUT timeout)  # from coreutils, like most of what the script calls
mark_as_advanced(TEXMAP_SH TEXMAP_TIMEOUT)
# What is graded is built without instruments in a build of its own: an instrumented build has nothing to add.
if(UNIX AND TEXMAP_SH AND TEXMAP_TIMEOUT AND NOT TEXMAP_INSTRUMENT)
  add_executable(wrong_pictures grade/wrong_pictures.cpp)
  target_link_libraries(wrong_pictures PRIVATE project_options app)
  target_include_directories(wrong_pictures PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}" "${TEXMAP_CHAPTERS}")
  set_target_properties(wrong_pictures PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")

  set(grade_test "${TEXMAP_SH}" "${CMAKE_CURRENT_SOURCE_DIR}/grade/test_grade.sh"
    "$<TARGET_FILE:compare_program>" "$<TARGET_FILE:wrong_pictures>" "${CMAKE_BINARY_DIR}/grade")
  add_test(NAME grade COMMAND ${grade_test})
  add_test(NAME grade_can_fail COMMAND ${grade_test} --self-test)
  # Alone on the machine: one of its students must be stopped in time and the others must not.
  set_tests_properties(grade PROPERTIES LABELS grade RUN_SERIAL ON TIMEOUT 600 ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER}")
  set_tests_properties(grade_can_fail PROPERTIES LABELS grade TIMEOUT 120)
endif()

# What build_and_run.py contains, limits and keeps: attacks, loops and cheats by students' programs.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND PYTHON3 AND NOT TEXMAP_INSTRUMENT)
  set(learn_build "${CMAKE_BINARY_DIR}/grade/learn")
  if(TEST learn_build AND CMAKE_GENERATOR STREQUAL "Unix Makefiles")
    set(learn_build "${CMAKE_BINARY_DIR}/learn")
  endif()
  add_test(NAME build_and_run COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/grade/test_build_and_run.py" "${CMAKE_SOURCE_DIR}"
    "${learn_build}" "${CMAKE_BINARY_DIR}/grade/boxes")
  set_tests_properties(build_and_run PROPERTIES LABELS grade SKIP_RETURN_CODE 77 TIMEOUT 1200 ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER}")
  if(TEST learn_build AND CMAKE_GENERATOR STREQUAL "Unix Makefiles")
    set_tests_properties(build_and_run PROPERTIES FIXTURES_REQUIRED learn_built)
  endif()
endif()
