# The build for learning: its programs draw the golden pictures, too, and say what they lack. Included by CMakeLists.txt here.

if(SH AND reference_platform AND NOT TEXMAP_INSTRUMENT)
  set(learn "${CMAKE_BINARY_DIR}/learn")
  get_property(chapters GLOBAL PROPERTY CHAPTERS)
  list(FILTER chapters EXCLUDE REGEX "^13_")  # it has all numbers there, too
  add_test(NAME learn_configure COMMAND "${CMAKE_COMMAND}" -S "${CMAKE_SOURCE_DIR}" -B "${learn}" -G "${CMAKE_GENERATOR}"
    "-DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}" -DCMAKE_BUILD_TYPE=Release -DTEXMAP_LEARN=ON)
  add_test(NAME learn_build COMMAND "${CMAKE_COMMAND}" --build "${learn}" --parallel 2 --target ${chapters} compare_program draw_mistakes)
  add_test(NAME learn_pictures COMMAND "${SH}" "${CMAKE_CURRENT_SOURCE_DIR}/golden/programs.sh" "${learn}/bin" ${chapters})
  add_test(NAME learn_has_one_number COMMAND "${learn}/bin/02_checkerboard_uv" --number float --out /dev/null)
  set_tests_properties(learn_has_one_number PROPERTIES PASS_REGULAR_EXPRESSION "This one was built for learning")
  # Chapter 01 has light alone, chapter 08 a texture and options.
  add_test(NAME learn_draws_mistakes_in_light COMMAND "${learn}/bin/draw_mistakes" 01 --out "${learn}/mistakes_01" --width 80 --height 60)
  set_tests_properties(learn_draws_mistakes_in_light PROPERTIES PASS_REGULAR_EXPRESSION "49 wrong pictures")
  add_test(NAME learn_draws_mistakes_in_maps COMMAND "${learn}/bin/draw_mistakes" 08 --out "${learn}/mistakes_08" --width 80 --height 60)
  set_tests_properties(learn_draws_mistakes_in_maps PROPERTIES PASS_REGULAR_EXPRESSION "6[0-9] wrong pictures")
  set_tests_properties(learn_configure PROPERTIES FIXTURES_SETUP learn_configured)
  set_tests_properties(learn_build PROPERTIES FIXTURES_REQUIRED learn_configured FIXTURES_SETUP learn_built TIMEOUT 600)
  set_tests_properties(learn_pictures learn_has_one_number learn_draws_mistakes_in_light learn_draws_mistakes_in_maps PROPERTIES
    FIXTURES_REQUIRED learn_built)
  set_tests_properties(learn_configure learn_build learn_pictures learn_has_one_number
    learn_draws_mistakes_in_light learn_draws_mistakes_in_maps PROPERTIES LABELS learn)
endif()
