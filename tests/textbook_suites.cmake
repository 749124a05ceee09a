# The textbook's rooms: number, math, sampling, scene, texture, and the formulas as published. Included by CMakeLists.txt here.

file(GLOB suites CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" number/test_number.cpp math/test_*.cpp sampling/test_*.cpp
  scene/test_*.cpp texture/test_*.cpp published/test_*.cpp)
list(TRANSFORM suites REPLACE "[.]cpp$" "")
foreach(suite IN LISTS suites)
  add_suite(${suite} ON render LABELS common textbook)
endforeach()
