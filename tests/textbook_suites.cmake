# The textbook's rooms: number, math, sampling, scene, texture, and the formulas as published. Included by CMakeLists.txt here.

foreach(suite
    number/test_number
    math/test_vec3
    sampling/test_alias_table
    sampling/test_directions
    sampling/test_hash
    sampling/test_samplers
    scene/test_camera
    scene/test_edge_function
    scene/test_floor
    scene/test_lens
    scene/test_light
    scene/test_mesh
    scene/test_nearest
    scene/test_paint
    scene/test_path
    scene/test_phong
    scene/test_shading_normal
    scene/test_sky
    scene/test_sky_path
    scene/test_sphere
    scene/test_triangle
    published/test_published_sphere
    support/test_dice)
  add_suite(${suite} ON texture LABELS common textbook)
endforeach()
foreach(suite
    math/test_rotation
    scene/test_lanes
    texture/test_bilinear
    texture/test_bump
    texture/test_checkerboard
    texture/test_conventions
    texture/test_environment
    texture/test_filters
    texture/test_footprint
    texture/test_image_texture
    texture/test_light_tables
    texture/test_mesh_mapping
    texture/test_normal_map
    texture/test_projection_facts
    texture/test_projections
    texture/test_pyramid
    texture/test_sky_moments
    texture/test_sky_sampler
    texture/test_smooth_texture
    texture/test_texel
    texture/test_wrap
    texture/test_wrapped
    published/test_brick_normals
    published/test_mip_map
    published/test_published_uv)
  add_suite(${suite} ON render LABELS common textbook)
endforeach()

# Formulas against more digits, where they are installed.
find_path(boost_multiprecision_INCLUDE_DIR boost/multiprecision/cpp_bin_float.hpp)
mark_as_advanced(boost_multiprecision_INCLUDE_DIR)
function(judge_by_more_digits)
  if(boost_multiprecision_INCLUDE_DIR)
    foreach(suite IN LISTS ARGN)
      target_include_directories(test_${suite} SYSTEM PRIVATE "${boost_multiprecision_INCLUDE_DIR}")
    endforeach()
  endif()
endfunction()
