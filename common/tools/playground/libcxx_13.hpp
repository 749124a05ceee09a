// What Emscripten's C++ library of 2022 lacks and its compiler has. Read before every file.
#pragma once
#include <bit>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace std {  // NOLINT(cert-dcl58-cpp): only where the library does not define them
#ifndef __cpp_lib_bit_cast
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif
#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class Array>
unique_ptr<Array> make_unique_for_overwrite(size_t count) {
  return unique_ptr<Array>(new remove_extent_t<Array>[count]);
}
#endif
}  // namespace std
