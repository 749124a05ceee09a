// Numbers in sentences.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// mingw's g++ has two kinds of printf; elsewhere there is one.
#if defined(__MINGW32__) && !defined(__clang__)
#define TEXMAP_FORMAT gnu::format(gnu_printf, 1, 2)
#else
#define TEXMAP_FORMAT gnu::format(printf, 1, 2)
#endif

namespace texmap {

/// What printf prints for these values, of any length. The compiler checks the values against the
/// format.
[[nodiscard, TEXMAP_FORMAT]] std::string text(const char* format, ...);

/// The number that a text such as `0.5`, `.5`, `5.` or `-5e-1` writes, in any locale; nothing for
/// another text and for a number beyond the largest double.
[[nodiscard]] std::optional<double> read_decimal(std::string_view text);

/// A number as people write it, 0.3 and not 0.299999, with at most so many digits.
[[nodiscard]] std::string shown(double value, int digits = 6);

/// A finite number in 15, 16 or 17 digits: the fewest that read back as the same number.
[[nodiscard]] std::string round_trip(double value);

/// A piece of a file as a message shows it: so many bytes at most, all of which a terminal shows.
[[nodiscard]] std::string quoted(std::string_view piece, std::size_t most = 24);

/// A text as HTML and SVG show it: &, <, > and " are escaped.
[[nodiscard]] std::string escaped_markup(const std::string& plain);

}  // namespace texmap
