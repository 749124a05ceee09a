// Text from students, made safe for terminals, tables and pages.
#pragma once
#include <string>
#include <string_view>

namespace texmap::grade {

/// The text on one line, in valid UTF-8, without control characters and without marks that turn
/// the direction of writing. Every other character stays as it is.
[[nodiscard]] std::string clean(std::string_view text);

/// A file's name to be shown: a byte that is not UTF-8 as its Latin-1 letter, as in archives from
/// older Windows systems, or as \xNN. A name in UTF-8 stays as it is.
[[nodiscard]] std::string shown_name(std::string_view name);

/// As clean(), but with line ends and at most so many characters; longer texts end in "...".
[[nodiscard]] std::string clean_lines(std::string_view text, std::size_t most_characters);

/// A cell of a table as RFC 4180 has it, always quoted. If a spreadsheet could take it for a
/// formula, an apostrophe stands in front of that, after leading blanks.
[[nodiscard]] std::string csv_cell(std::string_view text);

/// The word that a note begins with: "stripes" of "stripes: no squares; tried on +z". A name such
/// as std::fmod stays whole.
[[nodiscard]] std::string first_word(std::string_view note);

/// "word: note", where the note does not begin with the word.
[[nodiscard]] std::string with_word(const std::string& word, const std::string& note);

/// The name as a file name on any system: all but letters, digits, - and _ becomes _; never empty.
[[nodiscard]] std::string file_name_of(std::string_view name);

/// The text with blanks up to so many columns of a terminal; East Asian characters take two.
[[nodiscard]] std::string padded(const std::string& text, int columns);

/// How many things, in words: "1 pixel", "2 pixels".
[[nodiscard]] std::string counted(std::size_t count, const std::string& thing);

}  // namespace texmap::grade
