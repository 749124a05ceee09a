// Pages of the course's programs: pictures next to each other, tables, code before and after.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "texture/image.hpp"

namespace texmap::page {

/// What a page is made of. Strings named `html` go into the page as they are; all others are text,
/// which the functions below escape.
struct Frame {
  std::string title;   ///< text; also the first heading
  std::string style;   ///< CSS in addition to the common one, with its colors: --ink, --line, ...
  std::string script;  ///< JavaScript; a page without it allows none
};

/// A whole HTML page, in light and dark, that loads nothing from a network.
///
/// @param body_html  what comes below the heading
[[nodiscard]] std::string framed(const Frame& frame, const std::string& body_html);

/// A text that somebody else wrote as HTML. Markup is escaped; a byte that is not UTF-8, a control
/// character and a mark that turns the direction of writing each become U+FFFD. Lines stay.
[[nodiscard]] std::string escaped_foreign(std::string_view text);

/// A relative path as an address in a page: bytes that mean something there as %XX.
[[nodiscard]] std::string address_of(std::string_view path);

struct Picture {
  std::string address;  ///< a data URI, or a file as address_of writes it
  int width = 0;        ///< pixels
  int height = 0;
};

/// Bytes as text. Source: RFC 4648, section 4.
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// A picture with its bytes inside the page, which then is one file.
[[nodiscard]] Picture inside(const Image& image);

/// @param alternative  for readers who do not see it
[[nodiscard]] std::string picture(const Picture& picture, const std::string& alternative);

/// @param alternative  as for picture; the caption if empty
[[nodiscard]] std::string figure(const Picture& picture, const std::string& caption,
                                 const std::string& alternative = {});

/// Figures in a row, such as before, after and the map of differences; below each other where the
/// window is narrow.
[[nodiscard]] std::string side_by_side(const std::vector<std::string>& figures_html);

/// Two pictures of one size, one over the other, with a slider and buttons. Needs slider_script.
[[nodiscard]] std::string slider(const Picture& before, const std::string& before_name,
                                 const Picture& after, const std::string& after_name);
extern const char* const slider_script;

/// A table. The first cell of a row names it.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows_html);

/// What the page found, in one sentence or two.
[[nodiscard]] std::string verdict(bool good, const std::string& sentence_html);

/// Two versions of a source file as one text, with the lines marked that went and came; as many
/// lines as possible stay.
[[nodiscard]] std::string code_difference(std::string_view before_text,
                                          std::string_view after_text);

}  // namespace texmap::page
