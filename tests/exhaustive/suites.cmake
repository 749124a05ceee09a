# Every float of a kernel's domain, and every texel of every size. Included by tests/CMakeLists.txt.

# One row of floats of so many is run where programs are slow: sanitized, not optimised, no vectors.
set(one_row_of 1)
if(TEXMAP_INSTRUMENT OR CMAKE_BUILD_TYPE STREQUAL "Debug" OR NOT TARGET xsimd)
  set(one_row_of 64)
endif()
foreach(suite kernels texels)
  add_suite(exhaustive/test_exhaustive_${suite} ON draw LABELS exhaustive)
  target_compile_definitions(test_exhaustive_${suite} PRIVATE TEXMAP_EXHAUSTIVE_ONE_OF=${one_row_of})
  if(TAKES_GNU_OPTIONS)
    target_compile_options(test_exhaustive_${suite} PRIVATE $<$<CONFIG:Release>:-O3>)  # suites have -O1, which takes twice as long here
  endif()
  set_tests_properties(test_exhaustive_${suite} PROPERTIES PROCESSORS 2)
  set_target_properties(test_exhaustive_${suite} PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)  # they were made with -O1
endforeach()
