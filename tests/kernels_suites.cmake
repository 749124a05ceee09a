# The kernels against more digits, and their coefficients against the program that fits them. Included by CMakeLists.txt here, after
# extremes_suites.cmake, which looks for Boost.

foreach(suite turns reciprocal_root srgb_kernel power_kernel checker_kernel root_texture budget)
  add_suite(kernels/test_${suite} USES kernels LABELS common)
  if(boost_multiprecision_INCLUDE_DIR)
    target_include_directories(test_${suite} SYSTEM PRIVATE "${boost_multiprecision_INCLUDE_DIR}")
  endif()
endforeach()
if(reference_platform)  # the fit's bytes need an 80-bit long double and this C library
  add_test(NAME kernel_coefficients COMMAND fit_kernels --check "${CMAKE_SOURCE_DIR}/common/kernels/coefficients.hpp")
endif()
