# What the pages take from elsewhere: code, measured figures, diagrams. Included by CMakeLists.txt here.

# The figures are those of the reference platform: another C library may round a pixel another way.
add_executable(page_figures EXCLUDE_FROM_ALL
  pages/figures/chapter_00.cpp
  pages/figures/chapter_01.cpp
  pages/figures/chapter_02.cpp
  pages/figures/chapter_03.cpp
  pages/figures/chapter_04.cpp
  pages/figures/chapter_05.cpp
  pages/figures/chapter_06.cpp
  pages/figures/chapter_07.cpp
  pages/figures/chapter_08.cpp
  pages/figures/chapter_09.cpp
  pages/figures/chapter_10.cpp
  pages/figures/chapter_11.cpp
  pages/figures/chapter_12.cpp
  pages/figures/chapter_13.cpp
  pages/figures/chapter_14.cpp
  pages/figures/main.cpp)
target_include_directories(page_figures PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}/support" "${TEXMAP_CHAPTERS}")
target_link_libraries(page_figures PRIVATE project_options app chapters_code compare 13_speed_for_accuracy_code)
set_target_properties(page_figures PROPERTIES WIDER_REFERENCES ON)
if(TAKES_GNU_OPTIONS)  # as the suites: the figures are the same
  target_compile_options(page_figures PRIVATE $<$<CONFIG:Release>:-O1>)
  target_compile_definitions(page_figures PRIVATE TEXMAP_NO_FLATTEN)
endif()
# What an exercise of chapter 00 asks a student to change, so that its answer is a measured one.
file(READ "${CMAKE_SOURCE_DIR}/chapters/00_one_file/main.cpp" one_file)
string(REPLACE "0.001" "0" without_offset "${one_file}")
if(without_offset STREQUAL one_file)
  message(FATAL_ERROR "chapters/00_one_file/main.cpp has no 0.001, which its second exercise replaces")
endif()
# The page of chapter 03 shows pieces of code, each after a mark that says where it goes in chapter 00's file: all of them, put there.
set(earth_page "${CMAKE_SOURCE_DIR}/chapters/03_image_texture/README.md")
set(with_earth "${one_file}")
file(READ "${earth_page}" rest)
set(pieces 0)
string(FIND "${rest}" "<!-- earth: " at)
while(NOT at EQUAL -1)
  string(SUBSTRING "${rest}" ${at} -1 rest)
  string(FIND "${rest}" "\n```\n" end)
  string(SUBSTRING "${rest}" 0 ${end} block)
  if(NOT block MATCHES "^<!-- earth: (above|below) \"([^\"]+)\" -->\n```cpp\n(.+)$")
    message(FATAL_ERROR "${earth_page}: after <!-- earth: above|below \"TEXT\" --> comes a block of code")
  endif()
  set(verb "${CMAKE_MATCH_1}")
  set(text "${CMAKE_MATCH_2}")
  set(code "${CMAKE_MATCH_3}")
  string(FIND "${with_earth}" "${text}" first)
  string(FIND "${with_earth}" "${text}" last REVERSE)
  if(first EQUAL -1 OR NOT first EQUAL last)
    message(FATAL_ERROR "${earth_page}: chapters/00_one_file/main.cpp does not have this text once: ${text}")
  endif()
  if(verb STREQUAL above)
    string(APPEND code "\n${text}")
  else()
    string(PREPEND code "${text}\n")
  endif()
  string(REPLACE "${text}" "${code}" with_earth "${with_earth}")
  math(EXPR pieces "${pieces} + 1")
  string(SUBSTRING "${rest}" 1 -1 rest)
  string(FIND "${rest}" "<!-- earth: " at)
endwhile()
if(pieces EQUAL 0)
  message(FATAL_ERROR "${earth_page} has no piece of code for chapter 00's file")
endif()
foreach(change without_offset with_earth)
  file(CONFIGURE OUTPUT 00_${change}.cpp CONTENT "${${change}}" @ONLY)
  add_executable(00_${change} EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/00_${change}.cpp")
  target_link_libraries(00_${change} PRIVATE stb_image stb_image_write)
  target_compile_options(00_${change} PRIVATE $<$<BOOL:${TAKES_GNU_OPTIONS}>:-ffp-contract=off>)
  add_dependencies(page_figures 00_${change})
endforeach()
add_dependencies(page_figures 00_one_file 06_one_file 07_earth_by_sampling)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/chapters/00_one_file/main.cpp" "${earth_page}")
target_compile_definitions(page_figures PRIVATE TEXMAP_TESTS_DIR="${CMAKE_CURRENT_SOURCE_DIR}" TEXMAP_ASSETS_DIR="${CMAKE_SOURCE_DIR}/assets"
  TEXMAP_BIN_DIR="$<TARGET_FILE_DIR:page_figures>")
if(reference_platform AND NOT TEXMAP_INSTRUMENT)
  set_target_properties(page_figures PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_test(NAME page_figures COMMAND page_figures "${CMAKE_SOURCE_DIR}/docs/figures.txt")
  set_tests_properties(page_figures PROPERTIES LABELS pages)
endif()

if(NOT TEXMAP_INSTRUMENT)
  set_target_properties(draw_diagrams diagrams PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_test(NAME diagrams COMMAND draw_diagrams "${CMAKE_SOURCE_DIR}/docs/diagrams" --check)
  add_test(NAME diagrams_can_fail COMMAND draw_diagrams "${CMAKE_SOURCE_DIR}/docs" --check)
  set_tests_properties(diagrams_can_fail PROPERTIES WILL_FAIL ON)
  set_tests_properties(diagrams diagrams_can_fail PROPERTIES LABELS pages)
  add_suite(pages/test_diagrams ON diagrams LABELS pages)
  foreach(number 02 04 06 07 10 11 12 13 14)
    target_sources(test_diagrams PRIVATE pages/diagrams/chapter_${number}.cpp)
  endforeach()
endif()
add_suite(pages/test_page ON page LABELS pages)
if(nlohmann_json_INCLUDE_DIR)
  add_suite(playground/test_live ON app chapters_code test_support LABELS pages)
  target_include_directories(test_live PRIVATE "${CMAKE_SOURCE_DIR}/common/tools/playground")
  target_include_directories(test_live SYSTEM PRIVATE "${nlohmann_json_INCLUDE_DIR}")
endif()
add_suite(pages/test_pack_png POSIX ON picture LABELS pages)  # runs the program
if(TARGET test_pack_png)
  target_compile_definitions(test_pack_png PRIVATE TEXMAP_PACK_PNG="$<TARGET_FILE:pack_png>")
  add_dependencies(test_pack_png pack_png)
endif()
if(PYTHON3)
  add_test(NAME pages_script COMMAND "${PYTHON3}" "${CMAKE_SOURCE_DIR}/common/tools/pages/pages.py" "${CMAKE_SOURCE_DIR}" --self-test)
  add_test(NAME reference_pages COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/pages/reference_pages.py" "${CMAKE_SOURCE_DIR}")
  add_test(NAME reference_pages_script COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/pages/reference_pages.py" --self-test)
  set_tests_properties(pages_script reference_pages reference_pages_script PROPERTIES LABELS pages)
endif()
if(PYTHON3 AND TARGET book AND NOT TEXMAP_INSTRUMENT AND NOT WIN32)
  add_test(NAME book COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/pages/test_book.py" "$<TARGET_FILE:book>" "${CMAKE_SOURCE_DIR}"
    "$<TARGET_FILE_DIR:compare_steps>")
  set_tests_properties(book PROPERTIES LABELS pages SKIP_RETURN_CODE 77 TIMEOUT 1200)
endif()
if(SH AND reference_platform AND NOT TEXMAP_INSTRUMENT)
  set_target_properties(mark_crops PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_test(NAME page_pictures COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/pages/pictures.sh" "${CMAKE_SOURCE_DIR}" "$<TARGET_FILE_DIR:01_plain_spheres>")
  add_test(NAME page_pictures_can_fail COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/pages/pictures.sh" "${CMAKE_SOURCE_DIR}" "$<TARGET_FILE_DIR:01_plain_spheres>" --self-test)
  set_tests_properties(page_pictures page_pictures_can_fail PROPERTIES LABELS pages)
endif()
