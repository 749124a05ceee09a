# The suites of what makes lessons fast, safe and measurable: kinds of numbers and the rooms under engine/. Included by CMakeLists.txt here.

foreach(suite
    number/test_double_pair
    number/test_dual
    number/test_interval
    number/test_pack
    number/test_pack_fallback
    number/test_pack_u32
    number/test_pack_u32_fallback
    engine/kernels/test_kernel_plan
    engine/kernels/test_root_texture
    engine/kernels/test_turns
    engine/render/test_convert_projection
    engine/render/test_develop
    engine/render/test_film
    engine/render/test_pixel_patch
    engine/render/test_render
    engine/render/test_threads)
  add_suite(${suite} ON render LABELS common)
endforeach()
foreach(suite interleaved json plot text)
  add_suite(engine/measure/test_${suite} ON measure LABELS common)
endforeach()
add_suite(engine/system/test_files ON system LABELS common)
if(WIN32)
  add_suite(engine/system/test_windows_files ON system LABELS common)
endif()
add_suite(engine/system/test_posix_files POSIX ON picture LABELS common)
add_suite(engine/picture/test_find_texture POSIX ON picture LABELS common)  # changes the environment, makes links
add_suite(engine/mesh/test_box_tree ON mesh LABELS common)
add_suite(engine/mesh/test_read_obj ON mesh LABELS common)
foreach(suite bitmap_font damaged_images load_image save_png)
  add_suite(engine/picture/test_${suite} ON picture LABELS common)
endforeach()
add_suite(engine/picture/test_read_hdr ON picture LABELS common)
target_link_libraries(test_read_hdr PRIVATE stb_image stb_image_write)  # stb_image reads and writes the same files
target_link_libraries(test_save_png PRIVATE stb_image)
add_suite(engine/app/test_command_line ON app LABELS common)
add_suite(engine/app/test_gather_session ON app LABELS common)
add_suite(engine/app/test_lesson ON app LABELS common)
add_suite(engine/app/test_sampling_options ON app LABELS common)
add_suite(engine/app/test_session_line ON picture LABELS common)
target_compile_definitions(test_session_line PRIVATE TEXMAP_BIN="$<TARGET_FILE_DIR:05_y_rotation>/")
if(NOT TEXMAP_LEARN)
  target_compile_definitions(test_session_line PRIVATE TEXMAP_ALL_NUMBERS)
endif()
add_dependencies(test_session_line 05_y_rotation 09_texture_filtering 11_bump_and_normal_maps)
add_suite(engine/render/test_certainty_map ON app LABELS extremes)

# Numbers against more digits, and the kernels' coefficients against the program that fits them.
judge_by_more_digits(double_pair interval)
if(reference_platform)  # the fit's bytes need an 80-bit long double and this C library
  add_executable(check_kernels "${CMAKE_SOURCE_DIR}/common/tools/fit_kernels.cpp")
  target_link_libraries(check_kernels PRIVATE project_options)
  add_test(NAME kernel_coefficients COMMAND check_kernels --check "${CMAKE_SOURCE_DIR}/common/engine/kernels/coefficients.hpp")
endif()

# Each look-up instruction's own program: it has no other code, and does not run where the machine lacks the instructions.
foreach(instructions IN LISTS WIDE_PACKS)
  set(suite test_fetched_${instructions})
  add_executable(${suite} engine/render/test_fetched.cpp)
  target_include_directories(${suite} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(${suite} PRIVATE project_options render)
  target_compile_options(${suite} PRIVATE ${wide_${instructions}})
  set_target_properties(${suite} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  add_test(NAME ${suite} COMMAND ${suite} ${instructions})
  add_dependencies(suites_common ${suite})
  set_tests_properties(${suite} PROPERTIES LABELS common SKIP_RETURN_CODE 77)
endforeach()
