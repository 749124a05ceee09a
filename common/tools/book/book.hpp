// The book: every page of the course as HTML, with contents, search, pictures and sources.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace texmap::book {

/// What was made, and what is wrong with the pages.
struct Report {
  int pages = 0;
  int sources = 0;
  int pictures = 0;
  std::vector<std::string> faults;  ///< links and pictures that lead nowhere
};

/// Makes the book of the course in `root` in the folder `out`. Its pages have copies of the golden
/// pictures, because the reader may draw out/NN_name.png again, changed.
/// Errors: std::runtime_error if a page cannot be read or written.
/// @param with_print  also print.html, the pages of students and instructors in one, for paper
[[nodiscard]] Report make_book(const std::filesystem::path& root, const std::filesystem::path& out,
                               bool with_print = false);

}  // namespace texmap::book
