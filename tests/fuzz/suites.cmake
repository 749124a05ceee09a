# The fuzz targets. Where everything is compiled for libFuzzer (fuzz/fuzz.sh) each is a program that
# searches; in other builds replay_NAME runs its seeds and former finds once.

# add_fuzz_target(NAME [ON library ...] SEEDS folder ...): fuzz/NAME.cpp.
function(add_fuzz_target name)
  cmake_parse_arguments(ARG "" "" "ON;SEEDS" ${ARGN})
  set(program replay_${name})
  if(TEXMAP_INSTRUMENT MATCHES "fuzzer")
    set(program ${name})
    add_executable(${program} EXCLUDE_FROM_ALL fuzz/${name}.cpp)
    target_link_options(${program} PRIVATE -fsanitize=fuzzer)
  else()
    add_executable(${program} fuzz/${name}.cpp fuzz/replay.cpp)
    add_check(${program} common ${program} ${ARG_SEEDS} "${tests}/fuzz/finds/${name}")
    add_dependencies(suites_common ${program})
  endif()
  target_link_libraries(${program} PRIVATE project_options common ${ARG_ON})
  target_include_directories(${program} PRIVATE "${tests}")
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests$<0:>" WIDER_REFERENCES ON)
endfunction()

set(seeds "${tests}/fuzz/seeds")
add_fuzz_target(fuzz_load_image ON files stb_image SEEDS "${tests}/corpus")
add_fuzz_target(fuzz_read_hdr ON run SEEDS "${seeds}/fuzz_read_hdr")
add_fuzz_target(fuzz_read_obj ON fast files SEEDS "${seeds}/fuzz_read_obj")
