# Comparing pictures: the figures, the map, and the program. Included by tests/CMakeLists.txt.

add_suite(engine/compare/test_difference ON test_support LABELS compare)
add_suite(engine/compare/test_known_mistakes ON compare run LABELS compare)
set(slip_suites test_slips)
if(NOT TEXMAP_INSTRUMENT)  # 40 s of processor time, ten times as many with instruments
  list(APPEND slip_suites test_slips_of_chapters)
endif()
foreach(suite IN LISTS slip_suites)
  add_suite(engine/compare/${suite} ON compare run chapters_code LABELS compare)
  if(TARGET ${suite})
    target_sources(${suite} PRIVATE "${CMAKE_SOURCE_DIR}/common/tools/diagnose/slips.cpp")
    target_include_directories(${suite} PRIVATE "${TEXMAP_CHAPTERS}" "${CMAKE_SOURCE_DIR}/common/tools" "${CMAKE_SOURCE_DIR}/common/tools/diagnose")
  endif()
endforeach()
add_suite(engine/compare/test_diagnose POSIX ON compare run RUNS DIAGNOSE diagnose CHAPTER_03 03_image_texture LABELS compare)
add_suite(engine/compare/test_compare_program POSIX ON compare RUNS COMPARE compare_program LABELS compare)
