# Packs of every width, forced one after the other.

if(UNIX AND SH AND TARGET xsimd AND NOT TEXMAP_INSTRUMENT)  # instrumented packs have one width
  get_property(chapters GLOBAL PROPERTY CHAPTERS)
  list(FILTER chapters EXCLUDE REGEX "^(00|13|14)_")  # 00, 14: no packs; 13: the same by design
  add_check(packs laws "${SH}" "${tests}/packs/packs.sh" "$<TARGET_FILE_DIR:01_plain_spheres>" ${chapters})
endif()

add_check(broken_packages packages "${CMAKE_COMMAND}" "-DROOT=${CMAKE_SOURCE_DIR}" "-DCXX=${CMAKE_CXX_COMPILER}"
  "-DOUT=${CMAKE_CURRENT_BINARY_DIR}/broken" -P "${tests}/packs/broken_packages.cmake")

# The order in which the files of wide instructions are linked: a program with files that share a
# function of plain numbers must keep the one that every machine can run.
function(add_link_order_test)  # a function, because the folder of its chapter is its own
  set(TEXMAP_CHAPTERS "${tests}/packs/chapters")
  add_executable(99_link_order packs/chapters/99_link_order/main.cpp)
  target_link_libraries(99_link_order PRIVATE project_options run)
  add_wide_packs(99_link_order DRAWS lesson.hpp Lesson)
  set_target_properties(99_link_order PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  add_check(packs_99_link_order laws "${SH}" "${tests}/packs/wide.sh" "$<TARGET_FILE:99_link_order>" WITH SKIP_RETURN_CODE 77)
endfunction()
if(WIDE_PACKS AND SH AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_order_test()
endif()
