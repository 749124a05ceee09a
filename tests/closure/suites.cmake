# Each lesson touches only what it uses, and its reader answers for few headers.

# add_closure(CHAPTER HEADERS LINES [header ...]): at most so many headers and lines, none of these.
function(add_closure chapter headers lines)
  if(NOT TARGET ${chapter})
    return()
  endif()
  string(SUBSTRING "${chapter}" 0 2 number)
  set(symbols "")
  if(number LESS 3 AND CMAKE_NM)  # chapters without a picture decode none
    set(symbols "-DNM=${CMAKE_NM}" "-DPROGRAM=$<TARGET_FILE:${chapter}>"
      "-DSYMBOLS=stbi__(load|png|jpeg|zlib|parse|decode|info)|stbi_load|stbi_info")
  endif()
  add_check(closure_${number} "closure;reader;chapter-${number}" "${CMAKE_COMMAND}" "-DROOT=${CMAKE_SOURCE_DIR}" "-DLESSON=${TEXMAP_CHAPTERS}/${chapter}/lesson.hpp"
    "-DHEADERS=${headers}" "-DLINES=${lines}" "-DFORBIDDEN=${ARGN}" ${symbols} -P "${tests}/closure/closure.cmake")
endfunction()

set(by_07 path.hpp lens.hpp sampling_options.hpp)
set(by_06 phong.hpp phong_options.hpp ${by_07})
set(by_05 rotation.hpp rotated.hpp turntable.hpp ${by_06})
set(moved transformed.hpp uv_options.hpp look_up.hpp wrapped.hpp wrap.hpp)  # of 04 and 08 alone
set(by_04 conventions.hpp layout_options.hpp ${moved} ${by_05})
set(by_03 image.hpp image_texture.hpp texel.hpp texture_file.hpp ${by_04})
set(by_02 uv.hpp mapped.hpp checkerboard.hpp ${by_03})
add_closure(01_plain_spheres 16 1100 ${by_02})
add_closure(02_checkerboard_uv 19 1250 ${by_03})
add_closure(03_image_texture 27 1700 ${by_04})
add_closure(04_uv_conventions 45 2800 ${by_06})
add_closure(05_y_rotation 33 1950 ${moved} ${by_06})
add_closure(06_phong_texture_blend 36 2100 ${moved} ${by_07})
add_closure(07_earth_by_sampling 40 2400 ${moved})
add_closure(08_triangle_uv 45 2800)
add_closure(09_texture_filtering 47 3260)
add_closure(10_projections 45 2800 ${by_06})
add_closure(11_bump_and_normal_maps 50 3090)
add_closure(12_environment_map 45 2890)

# The rooms of common/: a header that climbs is refused with its name and its room.
add_check(layers "closure;reader" "${CMAKE_COMMAND}" "-DFOLDER=${CMAKE_SOURCE_DIR}/common" -P "${CMAKE_SOURCE_DIR}/common/layers.cmake")

# No work before main, in the libraries and in the chapters.
if(CMAKE_NM AND TAKES_GNU_OPTIONS AND NOT TEXMAP_INSTRUMENT)
  set(files "")
  foreach(library elementary texture files files_cold fast draw compare run)
    list(APPEND files "$<TARGET_FILE:${library}>")
  endforeach()
  foreach(chapter 01_plain_spheres 03_image_texture 06_phong_texture_blend 07_earth_by_sampling)
    if(TARGET ${chapter})
      list(APPEND files "$<TARGET_OBJECTS:${chapter}>")
    endif()
  endforeach()
  add_check(no_work_before_main "closure;reader" "${CMAKE_COMMAND}" "-DNM=${CMAKE_NM}" "-DFILES=${files}" -P
    "${tests}/closure/before_main.cmake")
endif()
