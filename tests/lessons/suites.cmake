# Lessons as their writers may write them, and what the compiler says of their mistakes.

add_suite(lessons/test_lessons ON run LABELS lessons)

# The changes that docs/how_to_change_things.md describes, applied to the chapters' own lessons.
if(PYTHON3)
  set(changes can fifth_sphere float_mapping int_stripes marble moved own_mapping own_texture plain plane second_picture stripes tiles)
  set(change_page "${CMAKE_SOURCE_DIR}/docs/how_to_change_things.md")
  list(TRANSFORM changes REPLACE "(.+)" "${CMAKE_CURRENT_BINARY_DIR}/changes/\\1.hpp" OUTPUT_VARIABLE change_headers)
  add_custom_command(OUTPUT ${change_headers}
    COMMAND "${PYTHON3}" "${tests}/lessons/changed.py" "${change_page}" "${TEXMAP_CHAPTERS}"
      "${CMAKE_CURRENT_BINARY_DIR}/changes" ${changes}
    DEPENDS "${change_page}" lessons/changed.py "${TEXMAP_CHAPTERS}/01_plain_spheres/lesson.hpp"
      "${TEXMAP_CHAPTERS}/02_checkerboard_uv/lesson.hpp" "${TEXMAP_CHAPTERS}/03_image_texture/lesson.hpp"
    COMMENT "Changing lessons as docs/how_to_change_things.md says" VERBATIM)
  add_suite(lessons/test_changes ON run LABELS lessons pages)
  target_sources(test_changes PRIVATE ${change_headers})
  target_include_directories(test_changes PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
endif()

# The chapters' tests with right lessons in plain C++, as students hand them in.
function(add_handed_in chapter text must_have)
  if(NOT text MATCHES "${must_have}")  # somebody changed the lesson
    if(TEXMAP_WERROR)
      message(FATAL_ERROR "the lesson of ${chapter} cannot be made one in plain C++")
    endif()
    message(STATUS "the lesson of ${chapter} is another one: its suite in plain C++ is left out")
    return()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${TEXMAP_CHAPTERS}/${chapter}/lesson.hpp")
  file(CONFIGURE OUTPUT handed_in/${chapter}/lesson.hpp CONTENT "${text}" @ONLY)
  configure_file(chapters/test_${chapter}.cpp handed_in_${chapter}.cpp COPYONLY)
  add_suite(${CMAKE_CURRENT_BINARY_DIR}/handed_in_${chapter} ON run chapters_code test_support LABELS lessons)
  target_include_directories(handed_in_${chapter} BEFORE PRIVATE "${CMAKE_CURRENT_BINARY_DIR}/handed_in")
endfunction()

# 02 by the textbook's formulas. A build for learning need not be told that std::acos has no packs.
file(READ "${TEXMAP_CHAPTERS}/02_checkerboard_uv/lesson.hpp" lesson)
string(REPLACE "#include <vector>" "#include <algorithm>\n#include <cmath>\n#include <numbers>\n#include <vector>" lesson "${lesson}")
string(REPLACE "using Checkered = Mapped<RtiowMapping" [[
struct TextbookMapping {
  template <class Real>
  Uv<Real> operator()(const Vec3<Real>& p) const {
    const Real pi = std::numbers::pi_v<Real>;
    Real u = std::atan2(-p.z, p.x) / (2 * pi) + Real(0.5);
    if (u >= 1) u = 0;
    return {u, std::acos(std::clamp(-p.y, Real(-1), Real(1))) / pi};
  }
};
using Checkered = Mapped<TextbookMapping]] lesson "${lesson}")
add_handed_in(02_checkerboard_uv "${lesson}" "<numbers>.*Mapped<TextbookMapping")
if(TARGET handed_in_02_checkerboard_uv)
  target_compile_definitions(handed_in_02_checkerboard_uv PRIVATE TEXMAP_LEARN)
endif()
# Chapter 04 in double alone.
file(READ "${TEXMAP_CHAPTERS}/04_uv_conventions/lesson.hpp" lesson)
string(REPLACE "  template <class Real>\n" "" lesson "${lesson}")
string(REPLACE "<Real>" "<double>" lesson "${lesson}")
string(REPLACE "\"sheet.hpp\"" "\"04_uv_conventions/sheet.hpp\"" lesson "${lesson}")
string(REPLACE "  };\n\n  Stage" "      .numbers = Numbers::only_double,\n  };\n\n  Stage" lesson "${lesson}")
add_handed_in(04_uv_conventions "${lesson}" "only_double.*<double>")

# add_mistake(NUMBER NAME MESSAGE): a lesson of mistakes.cpp does not compile, and the first error
# says the message, in the build for learning and in the other one.
function(add_mistake number mistake message)
  foreach(build TEXMAP_LEARN ALL_NUMBERS)
    if(build STREQUAL "TEXMAP_LEARN" AND mistake MATCHES "_in_")  # it has no packs, no intervals
      continue()
    endif()
    add_check(lesson_with_${mistake}_${build} lessons "${CMAKE_CXX_COMPILER}" -std=c++20
      -fsyntax-only -Wfatal-errors -Werror=switch -Werror=return-type -D${build}
      "-I${CMAKE_CURRENT_BINARY_DIR}/${mistake}" "-I${CMAKE_SOURCE_DIR}/common" "-DMISTAKE=${number}"
      "${tests}/lessons/mistakes.cpp"
      WITH PASS_REGULAR_EXPRESSION "${message}")
  endforeach()
endfunction()
if(TAKES_GNU_OPTIONS)
  add_mistake(1 misspelt_hook
    "biuld.*marked .*override.*, but does not override|only virtual member functions can be marked 'override'|biuld.*override")
  add_mistake(2 misspelt_fact "no non-static data member named .*idae|field designator 'idae'")
  add_mistake(3 no_hooks "a lesson begins with")
  add_mistake(4 no_facts "a lesson is a struct that says what it is about")
  add_mistake(5 call_that_is_not_const
    "a lesson is called with a Ray<Real>, from many threads.*is its operator.. const")
  add_mistake(6 vector_as_color "an object's color must be a Color<Real>: of a Vec3 p it is")
  add_mistake(7 texture_of_numbers "a texture .* returns no Color<Real> such as gray.x.")
  add_mistake(8 branch_in_packs "a pack of numbers has no single value for `if`.*Numbers::single")
  add_mistake(9 branch_in_intervals "may be both true and false, which `if` .*Numbers::single")
  add_mistake(10 wave_in_intervals "intervals have no sin.*Numbers::no_intervals")
  add_mistake(11 forgotten_build "a lesson with `options` uses them in")
  add_mistake(12 no_call
    "a lesson is called with a Ray<Real>, from many threads, and returns a Color<Real>")
  add_mistake(13 no_stage "a lesson has a member .stage., with a camera")
  add_mistake(14 hook_of_another "draw_all.*marked .*override|marked 'override' hides virtual")
  add_mistake(15 options_of_nobody ".options. names groups that are members of the lesson")
  add_mistake(16 group_without_declare "no member named .*declare")
  add_mistake(17 paint_without_call "a paint cannot be called with a hit")
  add_mistake(18 mapping_to_a_number "a mapping returns a Uv<Real>")
  add_mistake(19 paths_without_objects "a PathLesson has a list of Painted<Paint> in .objects.")
  add_mistake(20 ray_for_a_path
    "a PathLesson is called with a scene, a PixelPlace<Real> and random numbers")
  add_mistake(21 shape_without_distance
    "no matching function for call to .distance_to.const texmap::Disk|distance_to.*Disk")
  add_mistake(22 filter_without_case "enumeration value .?.?.?cubic.* not handled in switch")
  add_mistake(23 color_not_returned
    "no return statement in function returning non-void|non-void function does not return a value")
  add_mistake(24 private_base "a lesson begins with")
  add_mistake(25 no_idea "a lesson is a struct that says what it is about")
  add_mistake(26 facts_of_each "a lesson is a struct that says what it is about")
  add_mistake(27 path_to_a_vector "a PathLesson is called with .* returns a Color<Real>")
  add_mistake(28 shape_without_convex "a shape has distance_to, hit_at and a const convex")
  add_mistake(29 one_of_shapes_without_convex "a shape has distance_to, hit_at and a const convex")
  add_mistake(30 mapping_that_is_not_const "a mapping takes a Hit<Real> or its normal")
  file(READ "${CMAKE_SOURCE_DIR}/common/texture/filters.hpp" filters)
  string(REPLACE "  nearest, " "  cubic,\n  nearest, " filters "${filters}")
  file(CONFIGURE OUTPUT filter_without_case/texture/filters.hpp CONTENT "${filters}" @ONLY)
endif()

if(TEXMAP_LEARN AND SH AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT CMAKE_CXX_FLAGS MATCHES "libc[+][+]")
  add_executable(wrong_index lessons/wrong_index.cpp)
  target_link_libraries(wrong_index PRIVATE project_options run)
  target_include_directories(wrong_index PRIVATE "${TEXMAP_CHAPTERS}")
  learn_quickly(wrong_index)
  add_check(wrong_index lessons "${SH}" -c "'$<TARGET_FILE:wrong_index>' 2>&1 || echo ended" WITH PASS_REGULAR_EXPRESSION "error: the program was stopped.*objects.0. to objects.3.*ended")
endif()
