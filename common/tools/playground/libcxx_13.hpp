// What Emscripten's C++ library of 2022 lacks and its compiler has. Read before every file.
#pragma once
#include <bit>

namespace std {  // NOLINT(cert-dcl58-cpp): only where the library does not define them
#ifndef __cpp_lib_bit_cast
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif
}  // namespace std
