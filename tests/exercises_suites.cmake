# The exercises: each fails as shipped, its solution passes, each known mistake gets its word. Included by CMakeLists.txt here.

# What students get is made from the whole exercise, as `./course check reset` does; a student's own files are not on trial.
if(SH AND NOT TEXMAP_INSTRUMENT)  # students' mistakes divide by zero and convert NaN, and nothing else of the project is in them
  set(check_script "${CMAKE_SOURCE_DIR}/common/tools/check/check.sh")
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/starts")
  set(numbers_of_exercises 1 2 3)
  foreach(number 01 02 03 04 05 06 07 08 09 10 11 12)
    get_property(names GLOBAL PROPERTY EXERCISES_OF_${number})
    if(NOT names)
      continue()
    endif()
    set(starts "")
    set(functions "")
    set(rows "")
    foreach(k name IN ZIP_LISTS numbers_of_exercises names)
      set(start "${CMAKE_CURRENT_BINARY_DIR}/starts/${number}_${k}.hpp")
      add_custom_command(OUTPUT "${start}" COMMAND "${SH}" "${check_script}" start ${number}.${k} "${start}"
        DEPENDS exercises/${number}_${k}.hpp "${check_script}" WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}" COMMENT "" VERBATIM)
      list(APPEND starts "${start}")
      string(APPEND functions "namespace start_${k} {\n#include \"starts/${number}_${k}.hpp\"\n}\n")
      string(APPEND functions "namespace solution_${k} {\n#include \"exercises/${number}_${k}.hpp\"\n}\n")
      string(APPEND functions "static const auto ${name} = strangers_to(${k}, solution_${k}::${name});\n")
      string(APPEND rows "\n    {std::function(start_${k}::${name}), std::function(solution_${k}::${name})},")
    endforeach()
    configure_file(exercises/starts.hpp.in starts/${number}.hpp @ONLY)
    add_suite(exercises/test_exercises_${number} ON exercises_${number} compare LABELS chapter-${number} exercises)
    target_include_directories(test_exercises_${number} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
    target_sources(test_exercises_${number} PRIVATE ${starts})
    if(TAKES_GNU_OPTIONS)  # an exercise's function is declared nowhere else, its start does not use all it gets, and students mix int and double
      set_source_files_properties(exercises/test_exercises_${number}.cpp PROPERTIES
        COMPILE_OPTIONS "-Wno-missing-declarations;-Wno-unused-parameter;-Wno-conversion;-Wno-sign-conversion")
    endif()
  endforeach()
endif()
