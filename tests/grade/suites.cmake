# Grading students' folders, with every kind of student. Included by tests/CMakeLists.txt.

# Pictures and what comes out: tables, pages, files for learning systems.
if(UNIX AND PYTHON3)
  add_custom_target(test_grading ALL)
  add_dependencies(test_grading judge_pictures)
  add_check(test_grading "grading;posix" "${PYTHON3}" "${tests}/grade/test_grading.py" "$<TARGET_FILE_DIR:judge_pictures>")
endif()

# Checkouts: the course is built once more, as students' programs are built. What is contained,
# limited and kept: attacks, loops and cheats by students' programs.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND PYTHON3 AND NOT TEXMAP_INSTRUMENT)
  add_check(grade_checkouts grade "${PYTHON3}" "${tests}/grade/test_checkouts.py"
    "$<TARGET_FILE_DIR:judge_pictures>" "${CMAKE_BINARY_DIR}/grade" WITH SKIP_RETURN_CODE 77 TIMEOUT 1800)
endif()

# A student's copy of the course, built and used as students do.
if(SH AND PYTHON3 AND NOT TEXMAP_INSTRUMENT)
  add_check(students_copy grade "${SH}" "${tests}/grade/test_export.sh" "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}/copy"
    WITH TIMEOUT 900 PROCESSORS 2)
endif()
