// Measures the figures that the pages show and prints them: a name, a blank and the value a line.
// With the name of a file, says where that file has another value, and makes sure that it would.
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "figures.hpp"

namespace {

using texmap::test::Figures;
using InFile = std::map<std::string, std::string>;

/// Says where a file has other figures than were measured. @return  how many faults there are
int count_faults(const Figures& figures, const InFile& in_file, const std::string& file,
                 std::ostream& out) {
  int faults = 0;
  for (const auto& [name, value] : figures) {
    const auto found = in_file.find(name);
    const std::string there = found == in_file.end() ? "nothing" : found->second;
    if (there == value) continue;
    ++faults;
    out << "FAIL: " << name << " is " << value << ", and " << file << " has " << there << '\n';
  }
  if (in_file.size() > figures.size()) {
    ++faults;
    out << "FAIL: " << file << " has " << in_file.size() - figures.size()
        << " figures that are not measured\n";
  }
  return faults;
}

}  // namespace

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

  InFile in_file;
  std::ifstream file(argv[1]);
  for (std::string name, value; file >> name && std::getline(file >> std::ws, value);)
    in_file[name] = value;
  const int faults = count_faults(figures, in_file, argv[1], std::cerr);
  std::cout << figures.size() << " figures, " << faults << " faults\n";
  if (faults > 0 || in_file.empty()) return 1;

  // A figure that is another one, and one too many, would be noticed.
  std::ostringstream unread;
  InFile other = in_file;
  other.begin()->second += "1";
  const bool notices_another = count_faults(figures, other, "", unread) == 1;
  other = in_file;
  other["none"] = "1";
  if (notices_another && count_faults(figures, other, "", unread) == 1) return 0;
  std::cerr << "FAIL: a wrong figure is not noticed\n";
  return 1;
}
