// Whether a JPEG file is built as it should be.
#pragma once
#include "bytes.hpp"
#include "image_size.hpp"

namespace texmap {

[[nodiscard]] bool looks_like_jpeg(Bytes file);

/// Checks every segment of a JPEG file from its first to its end marker: tables, frame, scans, and the size of the picture.
///
/// The decoder behind this check trusts the tables and would write past its own with bad ones. Only the entropy-coded bits
/// themselves are left to it.
///
/// @param file  a file that looks_like_jpeg
/// Errors: Refusal.
/// Source: ITU-T T.81, annexes B, C and G.
[[nodiscard]] ImageSize check_jpeg(Bytes file);

}  // namespace texmap
