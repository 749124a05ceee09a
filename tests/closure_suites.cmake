# Each chapter touches only what it uses: a chapter must not include, or link, what a later chapter brings.

# add_closure(NAME CHAPTER SOURCE FORBIDS header ... [NO_SYMBOLS regex])
function(add_closure name chapter source)
  cmake_parse_arguments(ARG "" "NO_SYMBOLS" "FORBIDS" ${ARGN})
  set(symbols "")
  if(ARG_NO_SYMBOLS AND CMAKE_NM)
    set(symbols "-DNM=${CMAKE_NM}" "-DPROGRAM=$<TARGET_FILE:${chapter}>" "-DSYMBOLS=${ARG_NO_SYMBOLS}")
  endif()
  add_test(NAME ${name} COMMAND "${CMAKE_COMMAND}" "-DCOMPILER=${CMAKE_CXX_COMPILER}" "-DSOURCE=${source}"
    "-DINCLUDES=$<TARGET_PROPERTY:${chapter},INCLUDE_DIRECTORIES>;$<TARGET_PROPERTY:texture,INTERFACE_INCLUDE_DIRECTORIES>"
    "-DDEFINITIONS=$<TARGET_PROPERTY:${chapter},COMPILE_DEFINITIONS>" "-DFORBIDDEN=${ARG_FORBIDS}" ${symbols}
    -P "${CMAKE_CURRENT_SOURCE_DIR}/closure/closure.cmake")
  set_tests_properties(${name} PROPERTIES LABELS "closure")
endfunction()

set(brought_by_06 phong.hpp phong_options.hpp lecture_scene.hpp)
set(brought_by_05 rotation.hpp rotated.hpp rotation_options.hpp ${brought_by_06})
set(brought_by_04 conventions.hpp layout_options.hpp seed_formulas.hpp lettering.hpp ${brought_by_05})
set(brought_by_03 image_texture.hpp texel.hpp texture_file.hpp load_image.hpp find_texture.hpp stb_image.h ${brought_by_04})
set(brought_by_02 uv.hpp mapped.hpp checkerboard.hpp ${brought_by_03})
set(chapters "${CMAKE_SOURCE_DIR}/chapters")

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  add_closure(closure_01 01_plain_spheres "${chapters}/01_plain_spheres/main.cpp" FORBIDS ${brought_by_02} NO_SYMBOLS "stbi__(load|png|jpeg|zlib|parse|decode|info)|stbi_load|stbi_info")
  add_closure(closure_02 02_checkerboard_uv "${chapters}/02_checkerboard_uv/main.cpp" FORBIDS ${brought_by_03} NO_SYMBOLS "stbi__(load|png|jpeg|zlib|parse|decode|info)|stbi_load|stbi_info")
  add_closure(closure_03 03_image_texture "${chapters}/03_image_texture/main.cpp" FORBIDS ${brought_by_04})
  add_closure(closure_04 04_uv_conventions "${chapters}/04_uv_conventions/main.cpp" FORBIDS ${brought_by_05})
  add_closure(closure_05 05_y_rotation "${chapters}/05_y_rotation/main.cpp" FORBIDS ${brought_by_06})

  # The twins: a check that cannot fail is none.
  add_closure(closure_finds_an_include 01_plain_spheres "${CMAKE_CURRENT_SOURCE_DIR}/closure/forbidden_include.cpp" FORBIDS ${brought_by_02})
  set_tests_properties(closure_finds_an_include PROPERTIES PASS_REGULAR_EXPRESSION "forbidden_include.cpp includes uv.hpp")
  add_closure(closure_finds_a_symbol 03_image_texture "${chapters}/03_image_texture/main.cpp" FORBIDS phong.hpp NO_SYMBOLS "stbi__(load|png|jpeg|zlib|parse|decode|info)|stbi_load|stbi_info")
  set_tests_properties(closure_finds_a_symbol PROPERTIES PASS_REGULAR_EXPRESSION "03_image_texture contains stbi_")
endif()
