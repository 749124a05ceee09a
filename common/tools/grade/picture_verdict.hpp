// Whether a student's picture is right, and if not, what is wrong with it in words.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/compare/difference.hpp"
#include "grades.hpp"

namespace texmap::grade {

/// The words for a wrong picture; empty if no known mistake drew it.
using NameMistake = std::function<std::string(const Image& is)>;

/// A golden picture, read before any student's program runs, and what was found out about the
/// files that were compared with it: many students hand in the same bytes.
struct Golden {
  std::vector<std::uint8_t> file;
  Image picture;
  struct Verdict {
    std::vector<std::uint8_t> file;
    Row row;
  };
  std::vector<Verdict> verdicts;
};

/// Errors: FileError with the path.
[[nodiscard]] Golden read_golden(const std::filesystem::path& path);

/// A picture is right if at most 0.02 % of its pixels are off by more than one level, as in
/// tests/golden.
[[nodiscard]] bool is_right(const Figures& figures);

/// Compares the picture in a file with the golden one: sets the picture's part of a row.
///
/// Colors are compared; an alpha channel is not looked at, and the note says so.
/// A picture of another size is refused before it is unpacked.
void compare_with_golden(const std::filesystem::path& path, Golden& golden, Row& row,
                         const NameMistake& name = {});

/// The same for a second picture that the student does not know: sets `hidden`.
void compare_hidden(const std::filesystem::path& path, const std::filesystem::path& expected,
                    Row& row);

}  // namespace texmap::grade
