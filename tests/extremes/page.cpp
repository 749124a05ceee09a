// How the section of docs/numbers.md and the whole report are laid out.
#include "page.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace texmap::extremes {
namespace {

constexpr const char* report_title =
    "# Numbers, the whole report\n"
    "\n"
    "docs/numbers.md has the worst of each function, what the ladder of certainty is, and the "
    "units. Rows in *italics* are the source documents'\n"
    "or the textbooks' forms in the same test: there the bound is the one that is not kept, and "
    "a test fails if they ever keep it, since it\n"
    "would then see nothing.\n"
    "\n"
    "| column | meaning |\n"
    "|---|---|\n"
    "| function | what is claimed about; of a function with several promises, which |\n"
    "| number | `float`, `double`, `extended` (long double, 64 digits in base 2 on this kind "
    "of machine), or a pack of them, compared lane by lane |\n"
    "| domain | the inputs for which the bound holds; sizes are drawn so that every exponent "
    "is as likely as any other, and corners are drawn often |\n"
    "| bound | the largest error that is allowed there; 0 means that no error is allowed |\n"
    "| certainty | how sure the bound is, from the ladder of docs/numbers.md |\n"
    "| measured | the worst that was found, against 50-digit arithmetic |\n"
    "\n";

std::string plain(double number) {
  std::ostringstream text;
  text.precision(4);
  text << number;
  return text.str();
}

/// A number with two digits, such as 0.00071 or 3.4.
std::string two_digits(double number) {
  if (number == 0) return "0";
  std::ostringstream text;
  if (number >= 10 && number < 1e7) {
    const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
    text << static_cast<long>(std::round(number / unit) * unit);
    return text.str();
  }
  text.precision(2);
  text << number;
  return text.str();
}

/// What is said of a function: its bounds that hold, how sure each is, and the one that was nearest
/// to being reached.
struct OfFunction {
  std::string name;
  std::string bounds{};                 ///< each once
  std::map<std::string, long> rungs{};  ///< of the ladder of certainty
  const Claim* nearest = nullptr;
  double off = 0;

  void add(const Claim& claim, double measured) {
    const std::string bound = plain(claim.bound) + " " + claim.unit;
    if ((", " + bounds + ", ").find(", " + bound + ", ") == std::string::npos)
      bounds += (bounds.empty() ? "" : ", ") + bound;
    const std::string certainty = certainty_of(claim);
    ++rungs[certainty.substr(0, certainty.find_first_of(" ,"))];
    if (!(claim.bound > 0) || !(measured > 0)) return;
    if (nearest != nullptr && measured / claim.bound <= off / nearest->bound) return;
    nearest = &claim;
    off = measured;
  }

  /// A row of the page; its last two cells are measured.
  [[nodiscard]] std::string row() const {
    std::string row = "| " + name + " | " + bounds + " | ";
    std::string comma;
    for (const auto& [rung, count] : rungs) {
      row += comma + std::to_string(count) + " " + rung;
      comma = ", ";
    }
    if (nearest == nullptr) return row + " | | |\n";
    return row + " | " + nearest->function + ", " + nearest->number + ": " + two_digits(off) +
           " of " + plain(nearest->bound) + " " + nearest->unit + " | " + nearest->domain + " |\n";
  }
};

}  // namespace

Pages pages_of(const std::vector<Family>& families,
               const std::function<double(const Claim&)>& measured) {
  std::string rows;
  std::string report = report_title;
  long hold = 0;
  long broken = 0;
  std::set<std::string> functions;
  for (const Family& family : families) {
    report += "\n## " + family.title + "\n\n" + family.introduction + "\n\n";
    report +=
        "| function | number | domain | bound | certainty | measured |\n"
        "|---|---|---|---|---|---|\n";
    std::vector<OfFunction> all;
    for (const Claim& claim : family.claims) {
      const double worst = claim.certainty.empty() ? measured(claim) : 0;
      const std::string cell = claim.certainty.empty() ? two_digits(worst) : "";
      const bool holds = claim.expect == Expect::within;
      const std::string star = holds ? "" : "*";
      report += "| " + star + claim.function + star + " | " + claim.number + " | " + claim.domain +
                " | " + plain(claim.bound) + " " + claim.unit + " | " + certainty_of(claim) +
                " | " + cell + " |\n";
      ++(holds ? hold : broken);
      if (!holds) continue;
      const std::string name = claim.function.substr(0, claim.function.find(','));
      auto at = std::ranges::find(all, name, &OfFunction::name);
      if (at == all.end()) at = all.insert(at, OfFunction{.name = name});
      at->add(claim, worst);
    }
    for (const OfFunction& one : all) {
      functions.insert(one.name);
      rows += one.row();
    }
  }
  return {"## In short\n\n" + std::to_string(hold) + " bounds on " +
              std::to_string(functions.size()) + " functions hold. " + std::to_string(broken) +
              " forms from the source documents or from textbooks break such a bound,\nas they "
              "should: they show that the measurement can see an error. For each function the "
              "table names the bound that was nearest\nto being reached, and the inputs that it "
              "holds for; a bound of 0 allows no error at all.\n\n"
              "| function | bounds | how sure | nearest to its bound | for these inputs |\n"
              "|---|---|---|---|---|\n" +
              rows,
          report};
}

std::string with_in_short(const std::string& page, const std::string& in_short) {
  const std::size_t begin = page.find("## In short\n");
  return std::string(page).replace(begin, page.find("\n## ", begin) - begin, in_short);
}

std::string without_measured_cells(const std::string& page) {
  std::istringstream lines(page);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    // A row of the table has five cells, and so six bars; the last two are measured.
    if (std::count(line.begin(), line.end(), '|') == 6) {
      line.resize(line.rfind('|', line.size() - 2));
      line.resize(line.rfind('|'));
    }
    result += line + '\n';
  }
  return result;
}

}  // namespace texmap::extremes
