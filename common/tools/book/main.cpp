// Makes the book: out/index.html and the pages that it leads to.
// usage: book ROOT OUT [--print]     --print: also OUT/print.html, all of it on one page
#include <exception>
#include <iostream>
#include <string_view>

#include "book.hpp"

int main(int argc, char** argv) {
  const bool with_print = argc == 4 && std::string_view(argv[3]) == "--print";
  if (argc != 3 && !with_print) {
    std::cerr << "usage: book ROOT OUT [--print]\n";
    return 2;
  }
  try {
    const texmap::book::Report report = texmap::book::make_book(argv[1], argv[2], with_print);
    for (const std::string& fault : report.faults) std::cerr << "FAIL: " << fault << '\n';
    std::cout << report.pages << " pages, " << report.sources << " sources and " << report.pictures
              << " pictures are in " << argv[2] << "/index.html\n";
    return report.faults.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
