// The two checksums of a PNG file.
#pragma once
#include <cstdint>

#include "engine/picture/codecs/bytes.hpp"

namespace texmap {

/// CRC-32 of some bytes, as every chunk of a PNG file carries it.
///
/// Source: PNG specification, annex D.
[[nodiscard]] std::uint32_t crc32(Bytes bytes);

/// Adler-32 of some bytes, as a zlib stream carries it at its end.
///
/// Source: RFC 1950, section 8.2.
[[nodiscard]] std::uint32_t adler32(Bytes bytes);

}  // namespace texmap
