// Numbers in sentences.
#pragma once
#include <string>

namespace texmap {

/// What printf prints for these values, of any length. The compiler checks the values against the
/// format.
[[nodiscard, gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// A text as HTML and SVG show it: &, <, > and " are escaped.
[[nodiscard]] std::string escaped_markup(const std::string& plain);

}  // namespace texmap
