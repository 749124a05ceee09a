// Makes the book: out/index.html and the pages that it leads to.
// usage: book ROOT OUT
#include <exception>
#include <iostream>

#include "book.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: book ROOT OUT\n";
    return 2;
  }
  try {
    const texmap::book::Report report = texmap::book::make_book(argv[1], argv[2]);
    for (const std::string& fault : report.faults) std::cerr << "FAIL: " << fault << '\n';
    std::cout << report.pages << " pages, " << report.sources << " sources and " << report.pictures
              << " pictures are in " << argv[2] << "/index.html\n";
    return report.faults.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
