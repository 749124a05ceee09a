# The chapters' programs: add_chapter and what it needs. Included before chapters/.

set(TEXMAP_CHAPTERS "${CMAKE_SOURCE_DIR}/chapters" CACHE PATH "The folder of the chapters' code; ./course grade names a student's")
set(GALLERY "${CMAKE_SOURCE_DIR}/out" CACHE PATH "Where the pictures of all chapters and the gallery go")
set_property(GLOBAL PROPERTY CHAPTERS "")
add_library(chapters_code INTERFACE)

# The tools of instructors and engineers, and the tests beyond ./course test, need all chapters of
# the course: a copy with some of them (./course export, or a folder deleted) has none of these.
set(WHOLE_COURSE ON)
foreach(number RANGE 14)
  string(REGEX REPLACE "^([0-9])$" "0\\1" number "${number}")
  file(GLOB chapter "${CMAKE_SOURCE_DIR}/chapters/${number}_*")
  if(NOT chapter OR NOT EXISTS "${CMAKE_SOURCE_DIR}/common/tools/grade")
    set(WHOLE_COURSE OFF)
  endif()
endforeach()

# chapters_are_there(FILE OUT): whether the chapters are there that a source includes, as "02_checkerboard_uv/lesson.hpp".
# A students' copy without chapter 02 has that lesson in tests/neighbors/, for the tests of the chapters beside it.
function(chapters_are_there file out)
  set(${out} ON PARENT_SCOPE)
  file(STRINGS "${file}" includes REGEX "^#include \"[0-9][0-9]_[a-z0-9_]+/")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^#include \"([^/]*)/.*" "\\1" chapter "${include}")
    if(NOT IS_DIRECTORY "${CMAKE_SOURCE_DIR}/chapters/${chapter}" AND NOT IS_DIRECTORY "${CMAKE_SOURCE_DIR}/tests/neighbors/${chapter}")
      set(${out} OFF PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# Instructions that not every machine has, and the options that compile for them: packs made of them
# are compiled into files of their own and chosen when the program runs. Without FMA: a fused
# operation rounds once, and the pictures would differ.
set(wide_avx2 -mavx2)
separate_arguments(wide_avx512 NATIVE_COMMAND "${xsimd_OPTIONS}")
# g++ copies structures in pieces of 16 bytes, unless it is told that larger ones are as good. What is
# stored in pieces and loaded whole has to wait: chapter 07's drawing takes a third longer for it, where
# it has no patches. From version 16 on the first option sets both, and the second gives a warning.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-mmove-max=256 HAVE_MOVE_MAX)
if(HAVE_MOVE_MAX)
  list(APPEND wide_avx2 -mmove-max=256
    $<$<VERSION_LESS:${CMAKE_CXX_COMPILER_VERSION},16>:-mstore-max=256>)
endif()
if(MINGW)
  check_cxx_compiler_flag(-Wa,-muse-unaligned-vector-move HAVE_UNALIGNED_MOVES)
endif()
if(HAVE_UNALIGNED_MOVES)
  # On Windows g++ aligns the stack for 16 bytes, and then takes it for 32 or 64 (its bug 54412).
  list(APPEND wide_avx2 -Wa,-muse-unaligned-vector-move)
  list(APPEND wide_avx512 -Wa,-muse-unaligned-vector-move)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 warns of its own headers of these instructions.
  list(APPEND wide_avx2 -Wno-uninitialized -Wno-maybe-uninitialized)
  list(APPEND wide_avx512 -Wno-uninitialized -Wno-maybe-uninitialized)
endif()
set(WIDE_PACKS "")
if(xsimd_OPTIONS AND (NOT MINGW OR HAVE_UNALIGNED_MOVES))
  set(WIDE_PACKS avx2 avx512)
endif()

# Looking for a shared C++ library takes half a millisecond whenever a program starts, a twentieth
# of what drawing a plain scene does. Some systems have no other; sanitizers bring their own.
include(CheckLinkerFlag)
set(with_own_library -static-libstdc++ -static-libgcc)
check_linker_flag(CXX "${with_own_library}" HAVE_STATIC_LIBSTDCXX)
if(NOT HAVE_STATIC_LIBSTDCXX OR TEXMAP_INSTRUMENT)
  set(with_own_library "")
endif()

# add_wide_packs(NN_name DRAWS HEADER type ...): the objects NN_name_wide, a file for each set of
# wide instructions that draws what is defined in the chapter's HEADER. They come after main.cpp, as
# engine/draw/wide_packs.hpp explains. ./course bench links them, too.
function(add_wide_packs name)
  cmake_parse_arguments(ARG "" "" "DRAWS" ${ARGN})
  if(NOT WIDE_PACKS)
    return()
  endif()
  list(POP_FRONT ARG_DRAWS header)
  add_library(${name}_wide OBJECT)
  target_link_libraries(${name}_wide PRIVATE project_options run)
  target_compile_definitions(${name}_wide PRIVATE TEXMAP_WIDE_PACKS)
  string(SUBSTRING "${name}" 0 2 number)
  set(draws "")
  foreach(drawn IN LISTS ARG_DRAWS)
    set(work "texmap::WorkOf<texmap::chapter_${number}::${drawn}>")
    string(APPEND draws "template ${work}::Result texmap::run_in_wide_packs<texmap::Instructions::@instructions@>(\n    const ${work}&, texmap::NumberKind);\n")
  endforeach()
  foreach(instructions IN LISTS WIDE_PACKS)
    set(file "${CMAKE_CURRENT_BINARY_DIR}/${name}_${instructions}.cpp")
    string(CONFIGURE "${draws}" definitions @ONLY)
    configure_file("${CMAKE_SOURCE_DIR}/common/engine/run/wide_packs.cpp.in" "${file}" @ONLY)
    set_source_files_properties("${file}" PROPERTIES COMPILE_OPTIONS "${wide_${instructions}}")
    target_sources(${name}_wide PRIVATE "${file}")
  endforeach()
  target_sources(${name} PRIVATE $<TARGET_OBJECTS:${name}_wide>)
  target_compile_definitions(${name} PRIVATE TEXMAP_WIDE_PACKS)
endfunction()

# Programs for learning have one number, double, read the common headers precompiled and are
# optimised a little: a lesson then compiles in about a second. They draw the same pictures. What
# takes time when they run, and what measures times, is compiled as for release: the user's times
# are those of fast programs.
# A wrong index of a list, such as objects[4] of four, stops the program: libstdc++ says so, libc++
# only traps, Visual C++ does not look.
set(learn_definitions TEXMAP_LEARN TEXMAP_NO_FLATTEN
  _GLIBCXX_ASSERTIONS _LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_FAST)
if(TEXMAP_LEARN)
  set(CMAKE_PCH_PROLOGUE "")  # else the common headers count as a system's, and a switch that lacks a case is no error
  file(WRITE "${CMAKE_BINARY_DIR}/learn_headers.cpp" "")
  add_library(learn_headers OBJECT "${CMAKE_BINARY_DIR}/learn_headers.cpp")
  target_link_libraries(learn_headers PRIVATE project_options run)
  target_compile_definitions(learn_headers PUBLIC ${learn_definitions})
  target_compile_options(learn_headers PRIVATE ${learn_options})
  target_precompile_headers(learn_headers PRIVATE "${CMAKE_SOURCE_DIR}/common/engine/run/precompiled.hpp")
endif()

# learn_quickly(TARGET): what learners compile again and again, in the build for learning.
function(learn_quickly target)
  if(TEXMAP_LEARN)
    target_compile_definitions(${target} PRIVATE ${learn_definitions})
    target_compile_options(${target} PRIVATE ${learn_options})
    target_precompile_headers(${target} REUSE_FROM learn_headers)
  endif()
endfunction()

file(GLOB ASSETS CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/assets/*.png" "${CMAKE_SOURCE_DIR}/assets/*.hdr")

# draw_picture(NN_name [MAY_FAIL] [option ...]): the target draw_NN_name draws the chapter's picture
# into the gallery, again only when the program or an asset has changed. MAY_FAIL: where the program
# fails, the gallery goes on without its picture.
function(draw_picture name)
  cmake_parse_arguments(ARG "MAY_FAIL" "" "" ${ARGN})
  set(program ${name})
  if(ARG_MAY_FAIL)
    set(program "${CMAKE_COMMAND}" -P "${CMAKE_SOURCE_DIR}/common/tools/draw.cmake" "$<TARGET_FILE:${name}>")
  endif()
  set(picture "${GALLERY}/${name}.png")
  add_custom_command(OUTPUT "${picture}"
    COMMAND "${CMAKE_COMMAND}" -E make_directory "${GALLERY}"
    COMMAND ${program} --out "${picture}" ${ARG_UNPARSED_ARGUMENTS}
    DEPENDS ${name} ${ASSETS} COMMENT "" VERBATIM)
  add_custom_target(draw_${name} DEPENDS "${picture}")
endfunction()

# add_one_file(NAME SOURCE [CHAPTER]): the program bin/NAME from one file of plain C++ that uses
# nothing of common/. CHAPTER: it is a chapter of its own, with a picture, and SOURCE is in its
# folder; else its folder is another chapter's.
function(add_one_file name source)
  cmake_parse_arguments(ARG "CHAPTER" "" "" ${ARGN})
  get_filename_component(source "${CMAKE_SOURCE_DIR}/chapters/${name}/${source}" ABSOLUTE)
  add_executable(${name} "${source}")
  target_link_libraries(${name} PRIVATE project_options stb_image stb_image_write)
  if(TAKES_GNU_OPTIONS)  # all of it is one file; options of a source come after those of its program
    set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS -Wno-missing-declarations)
  endif()
  if(ARG_CHAPTER)
    set_property(GLOBAL APPEND PROPERTY CHAPTERS ${name})
    draw_picture(${name})
  endif()
endfunction()

# add_chapter(NN_name [ON library ...] [SINGLE_NUMBERS] [ALL_NUMBERS] [PACKS ...] [ALSO_DRAWS ...]
# [DRAWN_WITH ...]): the program bin/NN_name from the sources in the chapter's folder, with main.cpp
# in TEXMAP_CHAPTERS, and its picture.
# ON names further libraries; `run` is always linked. SINGLE_NUMBERS: its lesson says in `about`
# that it does not run on packs. ALL_NUMBERS: it needs them all, also when it is built for learning.
# `chapters_code` holds the further sources of all chapters, for programs that include lessons;
# those of a chapter with PACKS, which link wide packs, are NN_name_code.
# PACKS names what packs draw where it is not the lesson: a header of the chapter's, and the types in it.
# DRAWN_WITH: options for the gallery's picture. ALSO_DRAWS adds a second picture: its name and the options that draw it.
function(add_chapter name)
  cmake_parse_arguments(ARG "SINGLE_NUMBERS;ALL_NUMBERS" "" "ON;PACKS;DRAWN_WITH;ALSO_DRAWS" ${ARGN})
  file(GLOB further CONFIGURE_DEPENDS RELATIVE "${CMAKE_SOURCE_DIR}/chapters/${name}" "${CMAKE_SOURCE_DIR}/chapters/${name}/*.cpp")
  list(REMOVE_ITEM further main.cpp one_file.cpp)
  add_executable(${name} "${TEXMAP_CHAPTERS}/${name}/main.cpp")
  target_compile_definitions(${name} PRIVATE TEXMAP_CHAPTER="${name}")
  target_link_libraries(${name} PRIVATE project_options run ${ARG_ON})
  if(further)  # objects and not an archive: wide packs come after them
    set(sources "")
    foreach(source IN LISTS further)  # the course's own where a student's folder has none
      set(folder "${TEXMAP_CHAPTERS}")
      if(NOT EXISTS "${folder}/${name}/${source}")
        set(folder "${CMAKE_SOURCE_DIR}/chapters")
      endif()
      list(APPEND sources "${folder}/${name}/${source}")
    endforeach()
    add_library(${name}_code OBJECT ${sources})
    target_link_libraries(${name}_code PUBLIC run ${ARG_ON} PRIVATE project_options)
    if(ARG_ALL_NUMBERS)
      read_standard_headers(${name}_code)
    else()
      read_standard_headers(${name}_code COLD)
      if(learn_options AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # 14's sheet then takes 0.6 of the time, and compiles as fast
        target_compile_options(${name}_code PRIVATE $<$<CONFIG:Release>:-finline-small-functions>)
      endif()
    endif()
    target_sources(${name} PRIVATE $<TARGET_OBJECTS:${name}_code>)
  endif()
  target_link_options(${name} PRIVATE ${with_own_library})
  if(TEXMAP_LEARN AND NOT ARG_ALL_NUMBERS)
    learn_quickly(${name})
  elseif(ARG_PACKS)
    read_standard_headers(${name})
    add_wide_packs(${name} DRAWS ${ARG_PACKS})
  elseif(NOT ARG_SINGLE_NUMBERS)
    add_wide_packs(${name} DRAWS lesson.hpp Lesson)
  endif()
  if(further AND NOT ARG_PACKS)
    target_sources(chapters_code INTERFACE $<TARGET_OBJECTS:${name}_code>)
    target_link_libraries(chapters_code INTERFACE run ${ARG_ON})
  elseif(further AND TARGET ${name}_wide)
    target_compile_definitions(${name}_code PRIVATE TEXMAP_WIDE_PACKS)
    target_sources(${name}_code INTERFACE $<TARGET_OBJECTS:${name}_wide>)
  endif()
  set_property(GLOBAL APPEND PROPERTY CHAPTERS ${name})

  draw_picture(${name} ${ARG_DRAWN_WITH})
  if(ARG_ALSO_DRAWS)
    list(POP_FRONT ARG_ALSO_DRAWS stem first_file)
    add_custom_command(OUTPUT "${GALLERY}/${first_file}"
      COMMAND ${name} --quiet --out "${GALLERY}/${stem}" ${ARG_ALSO_DRAWS}
      DEPENDS ${name} ${ASSETS} COMMENT "" VERBATIM)
    add_custom_target(draw_${name}_also DEPENDS "${GALLERY}/${first_file}")
    add_dependencies(draw_${name} draw_${name}_also)
  endif()
endfunction()
