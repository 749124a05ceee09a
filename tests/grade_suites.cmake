# Grading students' folders, with every kind of student. Included by CMakeLists.txt here.

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
