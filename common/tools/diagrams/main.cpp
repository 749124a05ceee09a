// Writes all diagrams into a folder, or checks that they are there as they are drawn.
// usage: draw_diagrams FOLDER [--check]
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

#include "diagrams.hpp"

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  const bool check = argc == 3 && std::string(argv[2]) == "--check";
  if (argc != 2 && !check) {
    std::cerr << "usage: draw_diagrams FOLDER [--check]\n";
    return 2;
  }
  const fs::path folder = argv[1];
  int faults = 0;
  std::set<fs::path> drawn;
  for (const texmap::diagrams::Drawing& drawing : texmap::diagrams::all_diagrams()) {
    const fs::path path = folder / (drawing.name() + ".svg");
    if (!drawn.insert(path.filename()).second) {
      std::cerr << "FAIL: two diagrams have the name " << path << '\n';
      ++faults;
    }
    if (check) {
      std::ifstream file(path, std::ios::binary);
      const std::string there((std::istreambuf_iterator<char>(file)), {});
      if (there != drawing.svg()) {
        std::cerr << "FAIL: " << path << " is another one: run ./course diagrams\n";
        ++faults;
      }
    } else {
      std::ofstream file(path, std::ios::binary);
      file << drawing.svg();
      if (!file.flush()) {
        std::cerr << "error: cannot write " << path << '\n';
        return 1;
      }
    }
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".svg" && !drawn.contains(entry.path().filename())) {
      std::cerr << "FAIL: nothing draws " << entry.path() << '\n';
      ++faults;
    }
  }
  std::cout << drawn.size() << " diagrams\n";
  return faults == 0 ? 0 : 1;
}
