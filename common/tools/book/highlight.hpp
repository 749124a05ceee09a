// Code in colors: C++, and differences.
#pragma once
#include <string>

namespace texmap::book {

/// A line of C++ or of a build script as HTML: comments, texts and keywords in spans.
[[nodiscard]] std::string highlighted_line(const std::string& line);

/// A block of code as HTML.
///
/// @param language  as behind the fence: cpp, diff; others stay plain
[[nodiscard]] std::string highlighted_block(const std::string& code, const std::string& language);

/// A whole file, its lines numbered and named L1, L2 and so on.
[[nodiscard]] std::string highlighted_file(const std::string& code, bool is_cpp);

}  // namespace texmap::book
