# Comparing pictures: the figures, the map, and the program. Included by tests/CMakeLists.txt.

add_suite(engine/compare/test_difference ON test_support LABELS compare)
add_suite(engine/compare/test_known_mistakes ON compare run LABELS compare)
add_suite(engine/compare/test_slips ON compare run chapters_code LABELS compare)
if(TARGET test_slips)
  target_sources(test_slips PRIVATE "${CMAKE_SOURCE_DIR}/common/tools/diagnose/slips.cpp")
  target_include_directories(test_slips PRIVATE "${TEXMAP_CHAPTERS}" "${CMAKE_SOURCE_DIR}/common/tools" "${CMAKE_SOURCE_DIR}/common/tools/diagnose")
endif()
add_suite(engine/compare/test_diagnose POSIX ON compare run RUNS DIAGNOSE diagnose LABELS compare)
if(NOT TEXMAP_INSTRUMENT)  # 32 s of processor time, ten times as many with instruments
  add_suite(engine/compare/test_draw_mistakes ON compare run RUNS DRAW_MISTAKES draw_mistakes LABELS compare)
endif()
add_suite(engine/compare/test_compare_program POSIX ON compare RUNS COMPARE compare_program LABELS compare)
