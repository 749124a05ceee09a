// The sheets of the chapters as HTML: pieces of their golden pictures, with the words as text.
#pragma once
#include <string>

namespace texmap::book {

/// A chapter's page with its sheet as HTML in place of the sheet's picture; as it is, if it has no
/// sheet.
///
/// @param list      what stands on the sheets, as tests/pages/page_sheets.cpp prints it
/// Errors: std::runtime_error if the list is not that of the sheet.
[[nodiscard]] std::string with_sheet(const std::string& list, const std::string& chapter,
                                     std::string page);

}  // namespace texmap::book
