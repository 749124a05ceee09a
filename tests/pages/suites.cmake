# What the pages take from elsewhere: code, measured figures, diagrams.

add_executable(page_figures EXCLUDE_FROM_ALL pages/page_figures.cpp)
add_executable(page_sheets EXCLUDE_FROM_ALL pages/page_sheets.cpp)  # the book shows them in pieces
foreach(program page_figures page_sheets)
  target_include_directories(${program} PRIVATE "${tests}" "${tests}/support" "${TEXMAP_CHAPTERS}")
  target_link_libraries(${program} PRIVATE project_options run chapters_code 13_speed_for_accuracy_code compare)
  set_target_properties(${program} PROPERTIES WIDER_REFERENCES ON)
  if(TAKES_GNU_OPTIONS)  # as the suites: the figures are the same
    target_compile_options(${program} PRIVATE $<$<CONFIG:Release>:-O1>)
    target_compile_definitions(${program} PRIVATE TEXMAP_NO_FLATTEN)
  endif()
endforeach()
if(SH AND NOT WIN32 AND NOT TEXMAP_INSTRUMENT)
  foreach(list figures sheets)
    set_target_properties(page_${list} PROPERTIES EXCLUDE_FROM_ALL OFF)
    add_check(page_${list} pages "${SH}" -c "\"$0\" >\"$2\" && diff \"$1\" \"$2\"" "$<TARGET_FILE:page_${list}>"
      "${CMAKE_SOURCE_DIR}/docs/${list}.txt" "${CMAKE_CURRENT_BINARY_DIR}/page_${list}.txt")
  endforeach()
endif()

# The page of chapter 03 shows pieces of code, each after a mark that says where it goes in chapter
# 00's file: with all of them the file draws chapter 03's picture.
if(SH AND PYTHON3 AND NOT TEXMAP_INSTRUMENT)
  set(one_file "${CMAKE_SOURCE_DIR}/chapters/00_one_file/main.cpp")
  set(earth_page "${CMAKE_SOURCE_DIR}/chapters/03_image_texture/README.md")
  set(with_earth "${CMAKE_CURRENT_BINARY_DIR}/00_with_earth.cpp")
  add_custom_command(OUTPUT "${with_earth}"
    COMMAND "${PYTHON3}" "${tests}/pages/with_earth.py" "${earth_page}" "${one_file}" "${with_earth}"
    DEPENDS pages/with_earth.py "${earth_page}" "${one_file}" VERBATIM)
  add_executable(00_with_earth "${with_earth}")
  target_link_libraries(00_with_earth PRIVATE stb_image stb_image_write)
  if(TAKES_GNU_OPTIONS)
    target_compile_options(00_with_earth PRIVATE -ffp-contract=off)
  endif()
  add_check(page_03_in_one_file pages "${SH}" -c "\"$0\" --out \"$1\" && \"$2\" \"$1\" tests/golden/03_image_texture.png"
    "$<TARGET_FILE:00_with_earth>" "${CMAKE_CURRENT_BINARY_DIR}/00_with_earth.png" "$<TARGET_FILE:compare_program>"
    WITH WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}")  # the program looks for assets/ there
endif()

# docs/architecture.md tells how a program of one's own uses the textbook.
if(SH AND NOT TEXMAP_INSTRUMENT)
  add_check(outside_program pages "${SH}" "${tests}/pages/outside.sh" "${CMAKE_SOURCE_DIR}" "${CMAKE_CURRENT_BINARY_DIR}/outside")
endif()

if(NOT TEXMAP_INSTRUMENT)
  set_target_properties(draw_diagrams PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_check(diagrams pages draw_diagrams "${CMAKE_SOURCE_DIR}/docs/diagrams" --check)
endif()
add_suite(pages/test_page ON page LABELS pages)
if(nlohmann_json_INCLUDE_DIR)
  add_suite(playground/test_live ON run chapters_code test_support LABELS pages)
  target_include_directories(test_live PRIVATE "${CMAKE_SOURCE_DIR}/common/tools/playground")
  target_include_directories(test_live SYSTEM PRIVATE "${nlohmann_json_INCLUDE_DIR}")
endif()
add_suite(playground/test_microscope ON run chapters_code test_support LABELS pages)
if(PYTHON3)
  add_check(reference_pages pages "${PYTHON3}" "${tests}/pages/reference_pages.py" "${CMAKE_SOURCE_DIR}")
endif()
# In a browser: the live pictures, as they are in docs/live/, and the book. Where there is no
# browser the tests are skipped.
if(PYTHON3 AND NOT TEXMAP_INSTRUMENT AND NOT WIN32)
  function(add_browser_check name label script)
    add_check(${name} ${label} "${PYTHON3}" "${tests}/${script}.py" ${ARGN}
      WITH SKIP_RETURN_CODE 77 TIMEOUT 1500)
  endfunction()
  set(root "${CMAKE_SOURCE_DIR}")
  foreach(name live pages)
    add_browser_check(browser_${name} playground playground/test_${name} "${root}"
      "$<TARGET_FILE_DIR:01_plain_spheres>" "${root}/docs/live")
  endforeach()
  if(TARGET book)
    add_executable(print_microscope playground/print_microscope.cpp)
    target_link_libraries(print_microscope PRIVATE project_options files)
    set_target_properties(print_microscope PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests$<0:>")
    set(book "$<TARGET_FILE:book>" "${root}")
    add_browser_check(cover playground playground/test_cover ${book} "$<TARGET_FILE:print_microscope>")
    add_browser_check(served playground pages/test_served ${book})
    add_browser_check(book pages pages/test_book ${book} "$<TARGET_FILE_DIR:compare_steps>")
  endif()
endif()
if(SH AND NOT TEXMAP_INSTRUMENT)
  set_target_properties(mark_crops PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_check(page_pictures pages "${SH}" "${tests}/pages/pictures.sh" "${CMAKE_SOURCE_DIR}"
    "$<TARGET_FILE_DIR:01_plain_spheres>")
endif()
