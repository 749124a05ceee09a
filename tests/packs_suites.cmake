# Packs of every width, forced one after the other. Included by CMakeLists.txt here.

if(UNIX AND SH AND xsimd_INCLUDE_DIR AND NOT TEXMAP_INSTRUMENT)  # instrumented programs have packs of one width
  get_property(chapters GLOBAL PROPERTY CHAPTERS)
  list(FILTER chapters EXCLUDE REGEX "^(00|13|14)_")  # 00 and 14 are not drawn with packs
  add_check(packs laws "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/packs/packs.sh" "$<TARGET_FILE_DIR:01_plain_spheres>"
    ${chapters}
    13_speed_for_accuracy:functions)  # its sheet is the same for all packs by design; what it draws with them, its own tests compare
endif()

# The order in which the files of wide instructions are linked: a program with files that share a function of plain numbers must keep
# the one that every machine can run, and the same program linked the other way round must be noticed.
function(add_link_order_tests)  # a function, because the folder of its chapter is its own
  set(TEXMAP_CHAPTERS "${CMAKE_CURRENT_SOURCE_DIR}/packs/chapters")
  add_library(99_main OBJECT packs/chapters/99_link_order/main.cpp)
  target_compile_definitions(99_main PRIVATE TEXMAP_WIDE_PACKS)
  target_link_libraries(99_main PRIVATE project_options app)
  add_executable(99_link_order $<TARGET_OBJECTS:99_main>)
  add_wide_packs(99_link_order DRAWS lesson.hpp Lesson)
  add_executable(99_wrong_order $<TARGET_OBJECTS:99_link_order_wide> $<TARGET_OBJECTS:99_main>)
  foreach(program 99_link_order 99_wrong_order)
    target_link_libraries(${program} PRIVATE project_options app)
    set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests" LINKER_LANGUAGE CXX)
    add_test(NAME packs_${program} COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/packs/packs.sh" --functions
      "$<TARGET_FILE:${program}>")
    set_tests_properties(packs_${program} PROPERTIES LABELS laws SKIP_RETURN_CODE 77)
  endforeach()
  set_tests_properties(packs_99_wrong_order PROPERTIES PASS_REGULAR_EXPRESSION
    "99_wrong_order: wide instructions where every machine goes: .*plain_sum")
endfunction()
if(WIDE_PACKS AND SH AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_order_tests()
endif()
