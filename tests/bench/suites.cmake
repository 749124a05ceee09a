# What things take: bench_ratios. Nothing of it is built unless asked for: it takes a third as long
# as all the rest. Its tests have the label bench; the target `bench` builds what they need.

# Everything that is measured: the program and its tests use it.
add_library(bench_groups OBJECT EXCLUDE_FROM_ALL bench/chapters_group.cpp bench/ledger_group.cpp bench/report.cpp
  bench/uv_group.cpp)
target_compile_definitions(bench_groups PRIVATE TEXMAP_BENCH_GROUPS="${tests}/bench/groups.txt")
target_include_directories(bench_groups PUBLIC bench PRIVATE support "${tests}" "${TEXMAP_CHAPTERS}")
target_link_libraries(bench_groups PUBLIC run chapters_code compare PRIVATE project_options)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(bench_groups PRIVATE -Wno-restrict)  # g++ 12's std::string (bug 105651)
endif()

# Packs of wide instructions: files of their own, compiled with the options that the chapters' are.
# They are linked last, as common/engine/draw/wide_packs.hpp explains.
set(wide_sets ${WIDE_PACKS})
set(bench_objects bench_groups)
if(wide_sets)
  add_library(bench_wide OBJECT EXCLUDE_FROM_ALL)
  target_include_directories(bench_wide PRIVATE bench support "${tests}" "${TEXMAP_CHAPTERS}")
  target_link_libraries(bench_wide PRIVATE project_options run)
  target_compile_definitions(bench_wide PRIVATE TEXMAP_WIDE_PACKS)
  target_compile_definitions(bench_groups PUBLIC TEXMAP_WIDE_PACKS)
  list(APPEND bench_objects bench_wide)  # after the others
  get_property(chapters GLOBAL PROPERTY CHAPTERS)
  list(FILTER chapters EXCLUDE REGEX "^(00|13|14)_")  # which nothing here draws
  foreach(chapter IN LISTS chapters)
    list(APPEND bench_objects ${chapter}_wide)
  endforeach()
endif()
foreach(instructions IN LISTS wide_sets)
  set(wide_options ${wide_${instructions}})
  set(file "${CMAKE_CURRENT_BINARY_DIR}/bench_wide_${instructions}.cpp")
  configure_file(bench/wide.cpp.in "${file}" @ONLY)
  set_source_files_properties("${file}" PROPERTIES COMPILE_OPTIONS "${wide_options}")
  target_sources(bench_wide PRIVATE "${file}")
endforeach()

add_executable(bench_ratios EXCLUDE_FROM_ALL bench/bench_ratios.cpp)
target_link_libraries(bench_ratios PRIVATE ${bench_objects} project_options)
target_include_directories(bench_ratios PRIVATE "${tests}")
set_source_files_properties(bench/bench_ratios.cpp PROPERTIES COMPILE_DEFINITIONS "TEXMAP_PROJECT_DIR=\"${CMAKE_SOURCE_DIR}\"")

# To test them and not to time anything, they need not be fast: half the time to compile.
option(TEXMAP_BENCH_UNTIMED "Compile the benchmarks quickly; their times then mean nothing" OFF)
if(TEXMAP_BENCH_UNTIMED)
  foreach(target bench_groups bench_wide)
    if(TARGET ${target})
      target_compile_options(${target} PRIVATE -O1 $<$<CXX_COMPILER_ID:GNU>:-fexpensive-optimizations>)  # with vzeroupper
      target_compile_definitions(${target} PRIVATE TEXMAP_NO_FLATTEN)
    endif()
  endforeach()
endif()

# No clock: the pages name what is measured, and the programs say what they should.
add_suite(bench/test_bench_pages ON ${bench_objects} LABELS bench)
target_include_directories(test_bench_pages PRIVATE bench)
target_compile_definitions(test_bench_pages PRIVATE TEXMAP_PROGRAM="$<TARGET_FILE:bench_ratios>")
add_dependencies(test_bench_pages bench_ratios)
set_target_properties(test_bench_pages PROPERTIES EXCLUDE_FROM_ALL ON)
add_custom_target(bench DEPENDS test_bench_pages)
if(SH AND wide_sets)
  add_check(bench_wide_functions bench "${SH}" "${tests}/packs/wide.sh" "$<TARGET_FILE:bench_ratios>" WITH SKIP_RETURN_CODE 77)
endif()
