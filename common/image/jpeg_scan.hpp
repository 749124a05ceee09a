// A walk through the blocks of a JPEG scan.
#pragma once
#include <cstdint>
#include <vector>

#include "jpeg_bits.hpp"

namespace texmap {

/// The blocks of 8x8 of one color channel.
struct JpegPlane {
  std::uint32_t columns = 0;                  // blocks that hold a part of the picture
  std::uint32_t rows = 0;                     // blocks that hold a part of the picture
  std::uint32_t stride = 0;                   // blocks from one row to the next
  std::uint32_t across = 1;                   // blocks of a unit, 1 to 4
  std::uint32_t down = 1;                     // blocks of a unit, 1 to 4
  std::vector<std::uint64_t> known_not_zero;  // of each block the coefficients sent so far; progressive files only
};

/// A channel's part in a scan.
struct JpegScanChannel {
  JpegPlane* plane = nullptr;
  const JpegCodes* dc = nullptr;  // codes for the constant coefficient
  const JpegCodes* ac = nullptr;  // codes for the varying ones
};

/// What a scan sends.
struct JpegScan {
  std::vector<JpegScanChannel> channels;
  bool progressive = false;
  std::uint32_t first = 0, last = 63;  // coefficients, 0 to 63
  bool refines = false;                // one more bit of coefficients that were sent before
  std::uint32_t bit = 0;               // the lowest bit that is sent, 0 to 13
  std::uint64_t units = 0;             // blocks if there is one channel, otherwise groups of blocks from each channel
  std::uint32_t units_in_a_row = 0;
  std::uint64_t restart_interval = 0;  // units, 0 for none
};

/// Reads all codes of a scan and forgets them: afterwards it is known that they are all there and make sense.
///
/// @param data  from the first byte after the header of the scan to the end of the file
/// @return      what follows the scan
/// Errors: Refusal.
/// Source: ITU-T T.81, annexes F.2 and G.2.
[[nodiscard]] Bytes check_scan(const JpegScan& scan, Bytes data);

}  // namespace texmap
