# Comparing pictures: the figures, the map, the program, and all of them against other people's tools. Included by CMakeLists.txt here.

add_suite(engine/compare/test_difference ON compare LABELS compare)
add_suite(engine/compare/test_difference_map ON compare LABELS compare)
add_suite(engine/compare/test_figures_json ON compare LABELS compare)
add_suite(engine/compare/test_wrong_chapter ON compare app LABELS compare)

add_suite(engine/compare/test_compare_program ON compare LABELS compare)
target_compile_definitions(test_compare_program PRIVATE TEXMAP_COMPARE="$<TARGET_FILE:compare_program>")
add_dependencies(test_compare_program compare_program)

# Where these tools are not installed, the tests say so and count as skipped.
add_suite(engine/compare/test_against_imagemagick ON compare LABELS compare)
add_suite(engine/compare/test_against_scikit_image ON compare LABELS compare)
set_tests_properties(test_against_imagemagick test_against_scikit_image PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: ")
