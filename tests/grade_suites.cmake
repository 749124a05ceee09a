# Grading students' folders, with every kind of student. Included by CMakeLists.txt here.

find_program(SH sh)
mark_as_advanced(SH)

add_suite(grade/test_grading ON grading LABELS grading)
if(nlohmann_json_INCLUDE_DIR)
  add_suite(grade/test_grade_formats ON grading LABELS grading)
  target_include_directories(test_grade_formats SYSTEM PRIVATE "${nlohmann_json_INCLUDE_DIR}")
endif()
add_suite(grade/test_grade_program POSIX ON picture LABELS grading)
if(TARGET test_grade_program)
  target_compile_definitions(test_grade_program PRIVATE TEXMAP_GRADE="$<TARGET_FILE:grade>")
  add_dependencies(test_grade_program grade)
endif()

# With the real builder, which builds the course once more, as students' programs are built.
if(SH AND UNIX AND NOT TEXMAP_INSTRUMENT)
  add_test(NAME grade_checkouts COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/grade/checkouts.sh" "$<TARGET_FILE:grade>" "${CMAKE_BINARY_DIR}/grade")
  set_tests_properties(grade_checkouts PROPERTIES LABELS grade SKIP_RETURN_CODE 77 TIMEOUT 1800 RESOURCE_LOCK grade_build)
endif()

if(UNIX AND PYTHON3)
  add_test(NAME hidden_options COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/grade/test_hidden_options.py" "${CMAKE_SOURCE_DIR}"
    "$<TARGET_FILE:04_uv_conventions>")
  set_tests_properties(hidden_options PROPERTIES LABELS grading)
endif()

# What build_and_run.py contains, limits and keeps: attacks, loops and cheats by students' programs.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND PYTHON3 AND NOT TEXMAP_INSTRUMENT)
  add_test(NAME build_and_run COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/grade/test_build_and_run.py" "${CMAKE_SOURCE_DIR}"
    "${CMAKE_BINARY_DIR}/grade/build" "${CMAKE_BINARY_DIR}/grade/boxes")
  set_tests_properties(build_and_run PROPERTIES LABELS grade SKIP_RETURN_CODE 77 TIMEOUT 1200 RESOURCE_LOCK grade_build ENVIRONMENT "CXX=${CMAKE_CXX_COMPILER}")
endif()
