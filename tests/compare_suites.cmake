# Comparing pictures: the figures, the map, the program, and all of them against other people's tools. Included by CMakeLists.txt here.

add_suite(engine/compare/test_difference ON compare LABELS compare)
add_suite(engine/compare/test_difference_map ON compare LABELS compare)
add_suite(engine/compare/test_figures_json ON compare LABELS compare)
add_suite(support/test_same_picture ON compare test_support LABELS compare)
add_suite(engine/compare/test_wrong_chapter ON compare app LABELS compare)
add_suite(engine/compare/test_known_mistakes ON compare app LABELS compare)
if(NOT TEXMAP_INSTRUMENT)  # 32 s of processor time, ten times as many with instruments
  add_suite(engine/compare/test_draw_mistakes ON compare app LABELS compare)
  target_compile_definitions(test_draw_mistakes PRIVATE TEXMAP_DRAW_MISTAKES="$<TARGET_FILE:draw_mistakes>")
  add_dependencies(test_draw_mistakes draw_mistakes)
endif()

# These write lines for the shell. Where the other tools are not installed, the tests say so and count as skipped.
foreach(suite compare_program against_imagemagick against_scikit_image)
  add_suite(engine/compare/test_${suite} POSIX ON compare LABELS compare)
endforeach()
if(TARGET test_compare_program)
  target_compile_definitions(test_compare_program PRIVATE TEXMAP_COMPARE="$<TARGET_FILE:compare_program>")
  add_dependencies(test_compare_program compare_program)
  set_tests_properties(test_against_imagemagick test_against_scikit_image PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
endif()
