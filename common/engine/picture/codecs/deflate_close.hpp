// Compresses bytes as closely as deflate allows in a time that somebody still waits for.
#pragma once
#include "engine/picture/codecs/bytes.hpp"
#include "engine/picture/codecs/deflate_block.hpp"

namespace texmap::rfc1951 {

/// Writes all blocks of a deflate stream.
void put_closely(BitWriter& out, Bytes bytes);

}  // namespace texmap::rfc1951
