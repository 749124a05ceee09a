// Bytes as text.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace texmap {

/// Bytes in base64. Source: RFC 4648, section 4.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace texmap
