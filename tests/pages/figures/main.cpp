// Measures the figures that the pages show and prints them: a name, a blank and the value a line.
// With the name of a file, says where that file has another value.
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include "figures.hpp"

int main(int argc, char** argv) {
  using namespace texmap::test;
  if (argc > 2) {
    std::cerr << "usage: page_figures [FILE]\n";
    return 2;
  }
  Figures figures;
  for (auto* measure :
       {&figures_of_00, &figures_of_01, &figures_of_02, &figures_of_03, &figures_of_04,
        &figures_of_05, &figures_of_06, &figures_of_07, &figures_of_08, &figures_of_09,
        &figures_of_10, &figures_of_11, &figures_of_12, &figures_of_13, &figures_of_14})
    measure(figures);
  if (argc == 1) {
    for (const auto& [name, value] : figures) std::cout << name << ' ' << value << '\n';
    return 0;
  }

  std::map<std::string, std::string> in_file;
  std::ifstream file(argv[1]);
  for (std::string name, value; file >> name && std::getline(file >> std::ws, value);)
    in_file[name] = value;
  int faults = 0;
  for (const auto& [name, value] : figures) {
    const auto found = in_file.find(name);
    const std::string there = found == in_file.end() ? "nothing" : found->second;
    if (there == value) continue;
    ++faults;
    std::cerr << "FAIL: " << name << " is " << value << ", and " << argv[1] << " has " << there
              << '\n';
  }
  if (in_file.size() > figures.size()) {
    ++faults;
    std::cerr << "FAIL: " << argv[1] << " has " << in_file.size() - figures.size()
              << " figures that are not measured\n";
  }
  std::cout << figures.size() << " figures, " << faults << " faults\n";
  return faults == 0 ? 0 : 1;
}
