// Writes the diagrams that are computed into a folder, or checks that they are there as they are
// drawn. The other diagrams of the folder are sources themselves: they must have the same style.
// usage: draw_diagrams FOLDER [--check]
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

#include "diagrams.hpp"

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

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
  using namespace texmap::diagrams;
  for (auto* const chapter : {&diagrams_of_07, &diagrams_of_10, &diagrams_of_13}) {
    for (const Drawing& drawing : chapter()) {
      const fs::path path = folder / (drawing.name + ".svg");
      drawn.insert(path.filename());
      if (check && text_of(path) != drawing.svg()) {
        std::cerr << "FAIL: " << path << " is another one: run ./course pages --write\n";
        ++faults;
      }
      if (check) continue;
      std::ofstream file(path, std::ios::binary);
      file << drawing.svg();
      if (!file.flush()) {
        std::cerr << "error: cannot write " << path << '\n';
        return 1;
      }
    }
  }
  int others = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".svg" || drawn.contains(entry.path().filename())) continue;
    ++others;
    if (text_of(entry.path()).find(style()) != std::string::npos) continue;
    std::cerr << "FAIL: " << entry.path() << " has another style than those that are computed\n";
    ++faults;
  }
  std::cout << drawn.size() << " diagrams computed, " << others << " drawn by hand\n";
  return faults == 0 ? 0 : 1;
}
