# Packs of every width, forced one after the other. Included by CMakeLists.txt here.

if(UNIX AND SH AND xsimd_INCLUDE_DIR AND NOT TEXMAP_INSTRUMENT)  # instrumented programs have packs of one width
  add_test(NAME packs COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/packs/packs.sh" "$<TARGET_FILE_DIR:01_plain_spheres>"
    01_plain_spheres 02_checkerboard_uv 03_image_texture 04_uv_conventions 05_y_rotation 06_phong_texture_blend 07_earth_by_sampling
    13_speed_for_accuracy:functions)  # its sheet is the same for all packs by design; what it draws with them, its own tests compare
  add_test(NAME packs_can_differ COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/packs/packs.sh" --self-test "$<TARGET_FILE_DIR:01_plain_spheres>")
  set_tests_properties(packs packs_can_differ PROPERTIES LABELS laws)
endif()
