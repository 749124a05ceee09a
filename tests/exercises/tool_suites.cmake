# What ./course does with its builds, and what check and watch say, tried from outside.

if(SH AND NOT TEXMAP_INSTRUMENT)
  # What the program says of a mistake that no picture shows, and of an answer in another unit.
  write_attempt(almost_01_1 01.1 "#include \"${tests}/exercises/almost_01_1.hpp\"\n" "std::function(&::distance_to_bowl)" "")
  add_executable(almost_01_1 "${CMAKE_CURRENT_BINARY_DIR}/almost_01_1.cpp")
  target_link_libraries(almost_01_1 PRIVATE check_main exercises_01 project_options)
  set_source_files_properties("${CMAKE_CURRENT_BINARY_DIR}/almost_01_1.cpp" PROPERTIES COMPILE_OPTIONS "-Wno-missing-declarations")
  add_dependencies(almost_01_1 check_01 check_03)
  add_check(check_of_almost exercises almost_01_1 --title "is it met?" --out "${CMAKE_CURRENT_BINARY_DIR}/almost" WITH PASS_REGULAR_EXPRESSION
    "01.1  is it met[?] not yet\n.*3 of 14 values are wrong.*The exercise's picture does not show this mistake")
  add_check(check_of_the_end exercises almost_01_1 WITH ENVIRONMENT TEXMAP_END_HERE=1 PASS_REGULAR_EXPRESSION
    "01.1  not yet: your function ends the program")
  add_check(check_of_radians exercises check_01 --question 01.b --answer 1.19 --again
    WITH PASS_REGULAR_EXPRESSION "66[.]7857 too small \\(98[.]2 %\\)[.]\n.*: yours is in radians")
  add_check(check_of_fraction exercises check_03 --question 03.b --answer 0.006
    WITH PASS_REGULAR_EXPRESSION "yours is a fraction: multiply by 100")
  add_check(check_script "exercises;posix" "${SH}" "${tests}/exercises/test_check.sh" "${CMAKE_SOURCE_DIR}")
  if(TAKES_GNU_OPTIONS)
    add_check(compiler_words "exercises;posix" "${SH}" "${tests}/exercises/test_compiler_words.sh"
      "${CMAKE_SOURCE_DIR}" "${CMAKE_CXX_COMPILER}")
  endif()
  add_check(watch_script "exercises;posix" "${SH}" "${tests}/exercises/test_watch.sh" "${CMAKE_SOURCE_DIR}")
  add_check(course_builds "exercises;posix" "${SH}" "${tests}/exercises/test_builds.sh" "${CMAKE_SOURCE_DIR}")
endif()
