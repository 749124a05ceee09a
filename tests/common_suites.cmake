# The suites that prove the common code: one file a header, grouped by layer as common/ is.

add_suite(number/test_number USES number LABELS common)
add_suite(number/test_pack USES number LABELS common)
add_suite(number/test_interval USES number LABELS common)
add_suite(number/test_bits USES number LABELS common)
target_include_directories(test_bits PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/sampling")  # the list of numbers
add_suite(number/test_paired USES number LABELS common)

add_suite(math/test_vec3 USES math LABELS common)
add_suite(math/test_color USES render LABELS common)  # a mixed color is also followed to its byte
add_suite(math/test_rotation USES texture LABELS common)  # and a rotation to its u

add_suite(measure/test_interleaved USES measure LABELS common)

foreach(suite hash samplers directions)
  add_suite(sampling/test_${suite} USES sampling LABELS common)
endforeach()

add_suite(geometry/test_sphere USES texture LABELS common)  # a far sphere's error shows in (u, v)
add_suite(geometry/test_camera USES geometry LABELS common)
add_suite(geometry/test_nearest USES geometry LABELS common)
add_suite(geometry/test_screen_bounds USES geometry LABELS common)
add_suite(geometry/test_triangle USES geometry LABELS common)
add_suite(geometry/test_floor USES texture LABELS common)  # what its exact height is good for shows in a checkerboard

add_suite(texture/test_uv USES texture LABELS common)
add_suite(texture/test_texel USES texture LABELS common)
add_suite(texture/test_checkerboard USES texture LABELS common)
add_suite(texture/test_solid_checkerboard USES texture LABELS common)
add_suite(texture/test_image_texture USES texture LABELS common)
add_suite(texture/test_bilinear USES texture LABELS common)
# Each look-up instruction's own program: it has no other code, and does not run where the machine lacks the instructions.
get_directory_property(wide_sets DIRECTORY "${CMAKE_SOURCE_DIR}/chapters" DEFINITION WIDE_PACKS)
foreach(instructions IN LISTS wide_sets)
  get_directory_property(wide_options DIRECTORY "${CMAKE_SOURCE_DIR}/chapters" DEFINITION wide_${instructions})
  add_executable(test_fetched_texels_${instructions} texture/test_fetched_texels.cpp)
  target_link_libraries(test_fetched_texels_${instructions} PRIVATE project_options kernels)
  target_compile_options(test_fetched_texels_${instructions} PRIVATE ${wide_options})
  set_target_properties(test_fetched_texels_${instructions} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  add_test(NAME test_fetched_texels_${instructions} COMMAND test_fetched_texels_${instructions} ${instructions})
  set_tests_properties(test_fetched_texels_${instructions} PROPERTIES LABELS common SKIP_RETURN_CODE 77)
endforeach()
add_suite(texture/test_conventions USES texture LABELS common)
add_suite(texture/test_seed_formulas USES texture LABELS common)

add_suite(shading/test_light USES shading LABELS common)
add_suite(shading/test_phong USES shading LABELS common)
add_suite(shading/test_sky USES shading LABELS common)
add_suite(shading/test_pixel_patch USES shading texture LABELS common)
add_suite(shading/test_painted USES shading texture LABELS common)

add_suite(render/test_render USES render LABELS common)
add_suite(render/test_sureness USES options LABELS extremes)
add_suite(render/test_threads USES render LABELS common)
add_suite(geometry/test_seed_sphere USES geometry LABELS common)
add_suite(math/test_seed_blend USES math LABELS common)
