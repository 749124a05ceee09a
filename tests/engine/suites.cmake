# What makes lessons fast, safe and measurable: kinds of numbers and the rooms under engine/.

file(GLOB suites CONFIGURE_DEPENDS RELATIVE "${tests}" number/test_*.cpp engine/files/test_*.cpp
  engine/fast/test_*.cpp engine/draw/test_*.cpp engine/run/test_*.cpp engine/compare/test_interleaved.cpp
  engine/compare/test_trade.cpp)
list(TRANSFORM suites REPLACE "[.]cpp$" "")
list(FILTER suites EXCLUDE REGEX "number/test_number|test_fetched|test_certainty_map|test_session_line|test_trade_options")
if(NOT WIN32)
  list(REMOVE_ITEM suites engine/files/test_windows_files)
endif()
foreach(suite IN LISTS suites)
  set(posix "")
  if(suite MATCHES "posix_files|find_texture")  # changes the environment, makes links
    set(posix POSIX)
  endif()
  add_suite(${suite} ${posix} ON compare run LABELS common)
endforeach()
target_link_libraries(test_read_hdr PRIVATE stb_image stb_image_write)  # for the same files
target_link_libraries(test_save_png PRIVATE stb_image)
# A suite that runs chapters: those that its source names are built before it.
function(add_line_suite suite)
  add_suite(engine/run/${suite} ON files LABELS common)
  get_property(chapters GLOBAL PROPERTY CHAPTERS)
  file(READ engine/run/${suite}.cpp source)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${tests}/engine/run/${suite}.cpp")
  foreach(chapter IN LISTS chapters)
    if(source MATCHES "${chapter}[^a-z0-9_]")
      target_compile_definitions(${suite} PRIVATE TEXMAP_BIN="$<TARGET_FILE_DIR:${chapter}>/")
      add_dependencies(${suite} ${chapter})
    endif()
  endforeach()
  if(NOT TEXMAP_LEARN)
    target_compile_definitions(${suite} PRIVATE TEXMAP_ALL_NUMBERS)
  endif()
endfunction()
add_line_suite(test_session_line)
if(NOT TEXMAP_LEARN)
  add_line_suite(test_trade_options)
endif()

add_suite(engine/draw/test_certainty_map ON run LABELS extremes)

# The kernels' coefficients against the program that fits them.
if(TAKES_GNU_OPTIONS AND CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64")  # an 80-bit long double
  add_executable(check_kernels "${CMAKE_SOURCE_DIR}/common/tools/fit_kernels.cpp")
  target_link_libraries(check_kernels PRIVATE project_options common)
  add_test(NAME kernel_coefficients COMMAND check_kernels)
endif()

# Each look-up instruction has a program of its own, which does not run where the machine lacks it.
foreach(instructions IN LISTS WIDE_PACKS)
  set(suite test_fetched_${instructions})
  add_executable(${suite} engine/fast/test_fetched.cpp)
  target_include_directories(${suite} PRIVATE "${tests}")
  target_link_libraries(${suite} PRIVATE project_options draw)
  target_compile_options(${suite} PRIVATE ${wide_${instructions}})
  set_target_properties(${suite} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  add_check(${suite} common ${suite} ${instructions} WITH SKIP_RETURN_CODE 77)
  add_dependencies(suites_common ${suite})
endforeach()
