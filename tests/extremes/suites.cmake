# Errors against 50 digits: the suites, and the program that writes docs/numbers.md from the claims.

if(TEXMAP_INSTRUMENT)
  return()  # Boost's numbers take minutes to compile sanitized; other suites run the same functions
endif()
if(NOT boost_multiprecision_INCLUDE_DIR)
  message(STATUS "Boost.Multiprecision not found: no tests against 50 digits (Debian libboost-dev, Fedora boost-devel, Arch boost, brew boost)")
  return()
endif()

# A library, because four programs share it and Boost's numbers take long to compile.
add_library(claims STATIC extremes/page.cpp extremes/search.cpp)
foreach(family arithmetic derivatives functions kernels maps rotation secondary_rays shading spheres textures triangles uv)
  target_sources(claims PRIVATE extremes/claims_of_${family}.cpp)
endforeach()
target_link_libraries(claims PUBLIC texture PRIVATE fast project_options)
target_include_directories(claims PUBLIC extremes support "${tests}")
target_include_directories(claims SYSTEM PUBLIC "${boost_multiprecision_INCLUDE_DIR}")
set_target_properties(claims PROPERTIES WIDER_REFERENCES ON)
if(TAKES_GNU_OPTIONS)
  target_compile_options(claims PRIVATE $<$<CONFIG:Release>:-O1>)  # as suites: a third less time
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(claims PRIVATE -Wno-restrict)  # g++ 12's own std::string (bug 105651)
endif()

# Builds without optimisation are some ten times slower.
set(extremes_inputs 6000)
if(CMAKE_BUILD_TYPE STREQUAL "Debug")
  set(extremes_inputs 500)
endif()
foreach(suite extremes numbers_page)
  add_suite(extremes/test_${suite} ON claims LABELS extremes)
  target_compile_definitions(test_${suite} PRIVATE TEXMAP_EXTREMES_INPUTS=${extremes_inputs})
endforeach()

# ./course numbers runs it.
add_executable(numbers_page extremes/numbers_page.cpp)
target_link_libraries(numbers_page PRIVATE claims project_options)
add_custom_target(numbers COMMAND numbers_page "${CMAKE_SOURCE_DIR}/docs/numbers.md" "${CMAKE_SOURCE_DIR}/out/numbers.md" USES_TERMINAL)
