# Each lesson touches only what it uses, and its reader answers for few headers. Included by CMakeLists.txt here.

# add_closure(NAME LESSON HEADERS n LINES n [FORBIDS header ...] [PROGRAM target NO_SYMBOLS regex])
function(add_closure name lesson)
  cmake_parse_arguments(ARG "" "HEADERS;LINES;PROGRAM;NO_SYMBOLS" "FORBIDS" ${ARGN})
  set(symbols "")
  if(ARG_NO_SYMBOLS AND CMAKE_NM)
    set(symbols "-DNM=${CMAKE_NM}" "-DPROGRAM=$<TARGET_FILE:${ARG_PROGRAM}>" "-DSYMBOLS=${ARG_NO_SYMBOLS}")
  endif()
  add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DROOT=${CMAKE_SOURCE_DIR}" "-DLESSON=${lesson}"
    "-DHEADERS=${ARG_HEADERS}" "-DLINES=${ARG_LINES}" "-DFORBIDDEN=${ARG_FORBIDS}" ${symbols}
    -P "${CMAKE_CURRENT_SOURCE_DIR}/closure/closure.cmake")
  set_tests_properties(${name} PROPERTIES LABELS "closure;reader")
endfunction()

set(by_07 path.hpp lens.hpp sampling_options.hpp)
set(by_06 phong.hpp phong_options.hpp ${by_07})
set(by_05 rotation.hpp rotated.hpp turntable.hpp ${by_06})
set(by_04 conventions.hpp layout_options.hpp ${by_05})
set(by_03 image.hpp image_texture.hpp texel.hpp texture_file.hpp ${by_04})
set(by_02 uv.hpp mapped.hpp checkerboard.hpp ${by_03})
set(decoding "stbi__(load|png|jpeg|zlib|parse|decode|info)|stbi_load|stbi_info")
set(lessons "${TEXMAP_CHAPTERS}")

add_closure(closure_01 "${lessons}/01_plain_spheres/lesson.hpp" HEADERS 16 LINES 1100 FORBIDS ${by_02}
  PROGRAM 01_plain_spheres NO_SYMBOLS "${decoding}")
add_closure(closure_02 "${lessons}/02_checkerboard_uv/lesson.hpp" HEADERS 19 LINES 1250 FORBIDS ${by_03}
  PROGRAM 02_checkerboard_uv NO_SYMBOLS "${decoding}")
add_closure(closure_03 "${lessons}/03_image_texture/lesson.hpp" HEADERS 27 LINES 1700 FORBIDS ${by_04})
add_closure(closure_04 "${lessons}/04_uv_conventions/lesson.hpp" HEADERS 45 LINES 2800 FORBIDS ${by_06})
add_closure(closure_05 "${lessons}/05_y_rotation/lesson.hpp" HEADERS 33 LINES 1950 FORBIDS ${by_06})
add_closure(closure_06 "${lessons}/06_phong_texture_blend/lesson.hpp" HEADERS 35 LINES 2100 FORBIDS ${by_07})
add_closure(closure_07 "${lessons}/07_earth_by_sampling/lesson.hpp" HEADERS 40 LINES 2400)
add_closure(closure_08 "${lessons}/08_triangle_uv/lesson.hpp" HEADERS 45 LINES 2800)
add_closure(closure_09 "${lessons}/09_texture_filtering/lesson.hpp" HEADERS 45 LINES 2900)
add_closure(closure_10 "${lessons}/10_projections/lesson.hpp" HEADERS 45 LINES 2800 FORBIDS ${by_06})
add_closure(closure_11 "${lessons}/11_bump_and_normal_maps/lesson.hpp" HEADERS 45 LINES 2800)
add_closure(closure_12 "${lessons}/12_environment_map/lesson.hpp" HEADERS 45 LINES 2800)

# The rooms of common/: a header that climbs is refused with its name and its room.
add_check(layers "closure;reader" "${CMAKE_COMMAND}" "-DFOLDER=${CMAKE_SOURCE_DIR}/common" -P "${CMAKE_SOURCE_DIR}/common/layers.cmake")
add_check(architecture_page "closure;reader" "${CMAKE_COMMAND}" "-DROOT=${CMAKE_SOURCE_DIR}" -P
  "${CMAKE_CURRENT_SOURCE_DIR}/closure/architecture.cmake")

# No work before main, in the libraries and in the chapters.
if(CMAKE_NM AND TAKES_GNU_OPTIONS AND NOT TEXMAP_INSTRUMENT)
  set(files "")
  foreach(library texture picture kernels render app)
    list(APPEND files "$<TARGET_FILE:${library}>")
  endforeach()
  foreach(chapter 01_plain_spheres 03_image_texture 06_phong_texture_blend 07_earth_by_sampling)
    list(APPEND files "$<TARGET_OBJECTS:${chapter}>")
  endforeach()
  add_test(NAME no_work_before_main COMMAND "${CMAKE_COMMAND}" "-DNM=${CMAKE_NM}" "-DFILES=${files}" -P
    "${CMAKE_CURRENT_SOURCE_DIR}/closure/before_main.cmake")
  set_tests_properties(no_work_before_main PROPERTIES LABELS "closure;reader")
endif()
