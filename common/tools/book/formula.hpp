// Formulas of the pages, plain text that is indented, as MathML.
#pragma once
#include <optional>
#include <string>

namespace texmap::book {

/// A block of formulas as HTML, or nothing if it is something else: code, a command.
///
/// A letter is a variable, two and more are a name; `a/b` with blanks is a fraction of all between
/// two operators, without blanks one of its neighbors; `^` lifts, `_` lowers. Two and more blanks
/// begin a column. To add a sign, name it in `signs`.
[[nodiscard]] std::optional<std::string> html_of_formulas(const std::string& block);

}  // namespace texmap::book
