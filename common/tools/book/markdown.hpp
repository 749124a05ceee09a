// A page of Markdown as HTML, by cmark-gfm.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "highlight.hpp"

namespace texmap::book {

/// A heading of a page, and the words below it up to the next heading.
struct Section {
  int level;          ///< 1 to 6
  std::string id;     ///< what a link behind # names
  std::string title;  ///< without markup
  std::string words;  ///< for the search, without code
};

/// A page as HTML.
struct Converted {
  std::string html;
  std::vector<Section> sections;
  std::map<std::string, std::string> rows;  ///< of the loupe: the id of the first line of each
  std::vector<std::string> faults;          ///< what no line of code has, by a mark of rows
};

/// What a link or a picture of the page leads to in the book; empty: the link is plain text.
using Resolve = std::function<std::string(const std::string& url)>;

/// Where the code after a mark, <!-- code: FILE NAME -->, is from.
using Locate = std::function<Place(const std::string& mark, const std::string& code)>;

/// Converts a page: GitHub's Markdown; headings get the names that GitHub gives them. Behind a
/// picture with letters stands how high they are, <!-- letters: 20 px -->: they stay readable.
/// Before code stands which lines calculate rows of the loupe, <!-- rows: NAME @ PIECE | ... -->.
///
/// @param resolve  called with the address of each link and each picture
[[nodiscard]] Converted html_of_markdown(const std::string& markdown, const Resolve& resolve,
                                         const Locate& locate);

/// A piece of HTML with its addresses resolved: src="..." and href="...".
[[nodiscard]] std::string with_resolved(std::string html, const Resolve& resolve);

/// Replaces each `what` in a text.
void replace_all(std::string& in, const std::string& what, const std::string& by);

}  // namespace texmap::book
