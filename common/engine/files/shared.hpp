// What posix.cpp and windows.cpp share.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "engine/files/file_error.hpp"

namespace texmap {

/// What the system says about a file, in words that help.
[[nodiscard]] std::string words_of(const std::error_code& error);

/// Refuses an empty name and one with a zero byte, where the system would end it.
/// Errors: FileError.
void check_name(const std::filesystem::path& path);

/// The folder of a file; "." for a name without one.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& path);

/// Refuses a folder that is missing or a file. Errors: FileError.
void check_folder(const std::filesystem::path& folder);

/// Reads a file of a known size whole.
///
/// @param size       as the system says
/// @param read_some  reads up to so many bytes to a place; returns how many, 0 at the end
/// Errors: FileError for an empty file, one with more than `most_bytes`, and one that changes.
template <class ReadSome>
[[nodiscard]] std::vector<std::uint8_t> read_whole(std::uint64_t size, std::uint64_t most_bytes,
                                                   ReadSome read_some) {
  if (size == 0) throw FileError("the file is empty");
  if (size > most_bytes) {
    throw FileError("the file has " + std::to_string(size) + " bytes, more than " +
                    std::to_string(most_bytes) + " (" + std::to_string(most_bytes >> 20) + " MiB)");
  }
  // One byte more than the size, to notice a file that grows.
  const auto expected = static_cast<std::size_t>(size);
  std::vector<std::uint8_t> bytes(expected + 1);
  std::size_t have = 0;
  while (have < bytes.size()) {
    const std::size_t got = read_some(bytes.data() + have, bytes.size() - have);
    if (got == 0) break;
    have += got;
  }
  if (have != expected) throw FileError("the file changed while it was being read");
  bytes.resize(expected);
  return bytes;
}

}  // namespace texmap
