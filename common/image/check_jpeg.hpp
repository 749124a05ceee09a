// Whether a JPEG file is built as it should be.
#pragma once
#include "bytes.hpp"
#include "image_size.hpp"

namespace texmap {

[[nodiscard]] bool looks_like_jpeg(Bytes file);

/// Checks a JPEG file from its first to its last byte: tables, header, the size of the picture, and every code of every scan.
///
/// The decoder behind this check trusts the tables and would write past its own with bad ones; where pixels are missing, it
/// makes some up. After this check nothing is missing.
///
/// @param file  a file that looks_like_jpeg
/// Errors: Refusal.
/// Source: ITU-T T.81, annexes B, C, F and G.
[[nodiscard]] ImageSize check_jpeg(Bytes file);

}  // namespace texmap
