// SHA-256, to compare pictures with sums that were made elsewhere.
#pragma once
#include <span>

#include "support/running.hpp"

namespace texmap::test {

/// The SHA-256 of some bytes as 64 lower-case hexadecimal digits, by CMake.
[[nodiscard]] inline std::string sha256(std::span<const std::uint8_t> bytes) {
  const TemporaryFolder folder;
  put(folder / "bytes", {bytes.begin(), bytes.end()});
  return run("cmake -E sha256sum \"" + (folder / "bytes") + "\"").out.substr(0, 64);
}

}  // namespace texmap::test
