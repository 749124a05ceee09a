# Lessons as their writers may write them, and what the compiler says of their mistakes. Included by CMakeLists.txt here.

add_suite(lessons/test_lessons ON app LABELS lessons)

# The changes that docs/how_to_change_things.md describes, applied to the chapters' own lessons.
find_program(PYTHON3 python3)
if(PYTHON3)
  set(changes can fifth_sphere float_mapping int_stripes own_mapping own_texture plain plane stripes tiles)
  set(change_page "${CMAKE_SOURCE_DIR}/docs/how_to_change_things.md")
  list(TRANSFORM changes REPLACE "(.+)" "${CMAKE_CURRENT_BINARY_DIR}/changes/\\1.hpp" OUTPUT_VARIABLE change_headers)
  add_custom_command(OUTPUT ${change_headers}
    COMMAND "${PYTHON3}" "${CMAKE_CURRENT_SOURCE_DIR}/lessons/changed.py" "${change_page}" "${CMAKE_SOURCE_DIR}/chapters"
      "${CMAKE_CURRENT_BINARY_DIR}/changes" ${changes}
    DEPENDS "${change_page}" lessons/changed.py "${CMAKE_SOURCE_DIR}/chapters/01_plain_spheres/lesson.hpp"
      "${CMAKE_SOURCE_DIR}/chapters/02_checkerboard_uv/lesson.hpp" "${CMAKE_SOURCE_DIR}/chapters/03_image_texture/lesson.hpp"
    COMMENT "Changing lessons as docs/how_to_change_things.md says" VERBATIM)
  add_suite(lessons/test_changes ON app LABELS lessons pages)
  target_sources(test_changes PRIVATE ${change_headers})
  target_include_directories(test_changes PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")

  # Right lessons in plain C++, as students hand them in: the chapters' own tests, with those lessons. 02 has two: it declares its
  # numbers; and it does not, in the build for learning, which has one number.
  foreach(chapter IN ITEMS 01_plain_spheres 02_checkerboard_uv 04_uv_conventions)
    configure_file(chapters/test_${chapter}.cpp handed_in_${chapter}.cpp COPYONLY)
    add_suite(${CMAKE_CURRENT_BINARY_DIR}/handed_in_${chapter} ON app chapters_code test_support LABELS lessons)
  endforeach()
  # Chapter 04's is its own lesson in double alone.
  set(lesson "${CMAKE_SOURCE_DIR}/chapters/04_uv_conventions/lesson.hpp")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${lesson}")
  file(READ "${lesson}" plain)
  string(REPLACE "  template <class Real>\n" "" plain "${plain}")
  string(REPLACE "<Real>" "<double>" plain "${plain}")
  string(REPLACE "\"sheet.hpp\"" "\"04_uv_conventions/sheet.hpp\"" plain "${plain}")
  string(REPLACE "  };\n\n  Stage" "      .numbers = Numbers::only_double,\n  };\n\n  Stage" plain "${plain}")
  if(plain MATCHES "Real" OR NOT plain MATCHES "only_double")
    message(FATAL_ERROR "${lesson} cannot be made a lesson in plain double")
  endif()
  file(CONFIGURE OUTPUT handed_in/04_uv_conventions/lesson.hpp CONTENT "${plain}" @ONLY)
  configure_file(chapters/test_02_checkerboard_uv.cpp handed_in_02_learning.cpp COPYONLY)
  add_suite(${CMAKE_CURRENT_BINARY_DIR}/handed_in_02_learning ON app chapters_code test_support LABELS lessons)
  target_compile_definitions(handed_in_02_learning PRIVATE TEXMAP_LEARN)
  foreach(suite IN ITEMS 01_plain_spheres 02_checkerboard_uv 02_learning 04_uv_conventions)
    target_include_directories(handed_in_${suite} BEFORE PRIVATE lessons/handed_in "${CMAKE_CURRENT_BINARY_DIR}/handed_in"
      "${CMAKE_CURRENT_BINARY_DIR}")
    target_sources(handed_in_${suite} PRIVATE ${change_headers})
  endforeach()
endif()

# add_mistake(NAME NUMBER MESSAGE): a lesson that must not compile, and what the message must say.
function(add_mistake name number message)
  add_test(NAME lesson_${name} COMMAND "${CMAKE_CXX_COMPILER}" -std=c++20 -fsyntax-only -DTEXMAP_LEARN
    "-I${CMAKE_SOURCE_DIR}/common" "-DMISTAKE=${number}" "${CMAKE_CURRENT_SOURCE_DIR}/lessons/mistakes.cpp")
  set_tests_properties(lesson_${name} PROPERTIES LABELS lessons)
  if(message)
    set_tests_properties(lesson_${name} PROPERTIES PASS_REGULAR_EXPRESSION "${message}")
  endif()
endfunction()
if(TAKES_GNU_OPTIONS)
  add_mistake(without_a_mistake_compiles 0 "")
  add_mistake(with_a_misspelt_hook_does_not 1 "prepair.*marked .*override.*, but does not override|only virtual member functions can be marked 'override'|prepair.*override")
  add_mistake(with_a_misspelt_fact_does_not 2 "no non-static data member named .*idae|field designator 'idae'")
  add_mistake(without_hooks_does_not 3 "a lesson begins with")
  add_mistake(without_facts_does_not 4 "a lesson says what it is about")
  add_mistake(with_a_hook_that_lacks_its_parameter_does_not 5 "prepare.*override")
endif()
