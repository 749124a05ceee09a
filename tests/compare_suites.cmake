# Comparing pictures: the figures, the map, the program, and all of them against other people's tools. Included by CMakeLists.txt here.

add_suite(compare/test_difference USES compare LABELS compare)
