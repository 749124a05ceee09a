# The exercises: each fails as shipped, its solution passes, each known mistake gets its word.

if(NOT TEXMAP_INSTRUMENT)  # students' mistakes divide by zero and convert NaN
  get_property(numbers GLOBAL PROPERTY CHAPTERS_WITH_EXERCISES)
  foreach(number IN LISTS numbers)
    get_property(names GLOBAL PROPERTY EXERCISES_OF_${number})
    set(functions "")
    set(rows "")
    set(k 0)
    foreach(name IN LISTS names)
      math(EXPR k "${k} + 1")
      string(APPEND functions "namespace solution_${k} {\n#include \"exercises/${number}_${k}.hpp\"\n}\n")
      string(APPEND functions "static const auto ${name} = strangers_to(${k}, solution_${k}::${name});\n")
      string(APPEND rows "\n    std::function(solution_${k}::${name}),")
    endforeach()
    configure_file(exercises/solutions.hpp.in solutions/${number}.hpp @ONLY)
    add_suite(exercises/test_exercises_${number} ON exercises_${number} compare LABELS chapter-${number} exercises)
    target_include_directories(test_exercises_${number} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
    if(TAKES_GNU_OPTIONS)  # students' functions are declared nowhere else, and mix int and double
      set_source_files_properties(exercises/test_exercises_${number}.cpp PROPERTIES
        COMPILE_OPTIONS "-Wno-missing-declarations;-Wno-unused-parameter;-Wno-conversion;-Wno-sign-conversion")
    endif()
  endforeach()
endif()
