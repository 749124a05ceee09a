// The error budget: reading it, and picking the kernels that keep to it.
#include "budget.hpp"

#include <algorithm>
#include <charconv>
#include <locale>
#include <sstream>
#include <vector>

namespace texmap {
namespace {

std::string shown(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(2);
  out << value;
  return out.str();
}

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument("a budget is 'exact', 'texels=X' or 'levels=X' with a number X above 0 and up to 255, not '" +
                              std::string(text) + "'");
}

/// A kernel on offer: its errors and its time, as a part of the reference's.
struct UvOffer {
  KernelNumber number;
  int degree;
  UvError worst;
  double cost;
};

template <int Degree>
UvOffer offer(Directions directions, KernelNumber number, double cost_any, double cost_unit) {
  const bool unit = directions == Directions::unit;
  const auto worst = [&]<class T>() {
    return unit ? FastUnitMapping<Degree>::template worst<T> : FastMapping<Degree>::template worst<T>;
  };
  return {number, Degree,
          number == KernelNumber::single ? worst.template operator()<float>() : worst.template operator()<double>(),
          unit ? cost_unit : cost_any};
}

/// From the cheapest to the dearest. More terms never help float beyond degree 17, where rounding is what is left.
std::vector<UvOffer> uv_offers(Directions directions) {
  using enum KernelNumber;
  return {
      offer<5>(directions, single, 0.030, 0.022),  offer<7>(directions, single, 0.032, 0.025),
      offer<9>(directions, single, 0.035, 0.028),  offer<11>(directions, single, 0.037, 0.029),
      offer<13>(directions, single, 0.040, 0.034), offer<15>(directions, single, 0.043, 0.036),
      offer<17>(directions, single, 0.047, 0.039), offer<23>(directions, twice, 0.122, 0.103),
      offer<29>(directions, twice, 0.146, 0.121),  offer<35>(directions, twice, 0.170, 0.143),
  };
}

std::string describe(const UvChoice& choice, const Budget& budget, int width, int height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (choice.degree == 0) {
    return "(u, v) for " + to_text(budget) + " on " + size + ": the reference formula in double, by the C library, at cost 1";
  }
  return "(u, v) for " + to_text(budget) + " on " + size + ": polynomials in " +
         (choice.number == KernelNumber::single ? "float" : "double") + ", arc tangent of degree " +
         std::to_string(choice.degree) + (choice.directions == Directions::unit ? ", unit vectors" : "") + "; at worst " +
         shown(choice.worst_texels) + " texels and " + shown(choice.worst_levels) + " levels; " + shown(choice.cost) +
         " of the reference's time";
}

bool keeps_to(const Budget& budget, const UvChoice& choice) {
  switch (budget.unit) {
    case Budget::Unit::texels:
      return choice.worst_texels <= budget.limit;
    case Budget::Unit::levels:
      return choice.worst_levels <= budget.limit;
    case Budget::Unit::exact:
      break;
  }
  return false;
}

std::string describe(const std::string& what, const Budget& budget, int terms, double worst, const std::string& exact) {
  const std::string start = what + " for " + to_text(budget) + ": ";
  if (terms == 0) return start + exact;
  return start + "a polynomial of " + std::to_string(terms) + " terms; at worst " + shown(worst) + " levels";
}

}  // namespace

Budget parse_budget(std::string_view text) {
  if (text == "exact") return {};
  Budget budget;
  std::string_view number = text;
  if (text.starts_with("texels=")) {
    budget.unit = Budget::Unit::texels;
  } else if (text.starts_with("levels=")) {
    budget.unit = Budget::Unit::levels;
  } else {
    refuse(text);
  }
  number.remove_prefix(7);
  // from_chars would also take inf and nan: their first letter is no digit.
  if (number.empty() || !(number.front() == '.' || (number.front() >= '0' && number.front() <= '9'))) refuse(text);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), budget.limit);
  if (error != std::errc() || end != number.data() + number.size() || !(budget.limit > 0 && budget.limit <= 255)) refuse(text);
  return budget;
}

std::string to_text(const Budget& budget) {
  if (budget.unit == Budget::Unit::exact) return "exact";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(17);
  // The shortest text that is read as the same number.
  std::string number;
  for (int digits = 1; digits <= 17; ++digits) {
    out.str("");
    out.precision(digits);
    out << budget.limit;
    number = out.str();
    double again = 0;
    std::from_chars(number.data(), number.data() + number.size(), again);
    if (again == budget.limit) break;
  }
  return (budget.unit == Budget::Unit::texels ? "texels=" : "levels=") + number;
}

UvChoice choose_uv_kernel(const Budget& budget, int width, int height, Directions directions) {
  if (width < 1 || height < 1) {
    throw std::invalid_argument("a texture is at least 1x1, not " + std::to_string(width) + "x" + std::to_string(height));
  }
  for (const UvOffer& offer : uv_offers(directions)) {
    const double u = offer.worst.u * width;
    const double v = offer.worst.v * height;
    UvChoice choice{directions, offer.number, offer.degree, std::max(u, v), 255 * (u + v), offer.cost, {}};
    if (keeps_to(budget, choice)) {
      choice.text = describe(choice, budget, width, height);
      return choice;
    }
  }
  UvChoice choice{directions, KernelNumber::reference, 0, 0, 0, 1, {}};
  choice.text = describe(choice, budget, width, height);
  return choice;
}

ColorChoice choose_srgb_kernel(const Budget& budget) {
  ColorChoice choice{0, 0, {}};
  if (budget.unit == Budget::Unit::levels && budget.limit >= 1) choice = {4, 1, {}, fits::SrgbCurve<4>::worst};
  if (budget.unit == Budget::Unit::levels && budget.limit >= 2) choice = {3, 2, {}, fits::SrgbCurve<3>::worst};
  choice.text = describe("sRGB bytes", budget, choice.terms, choice.worst_levels, "the exact curve, by thresholds");
  return choice;
}

ColorChoice choose_power_kernel(const Budget& budget) {
  ColorChoice choice{0, 0, {}};
  const auto try_terms = [&]<int Terms>() {
    const double worst = PowerKernel<Terms>::template worst_levels<float>;
    if (choice.terms == 0 && budget.unit == Budget::Unit::levels && worst <= budget.limit) choice = {Terms, worst, {}};
  };
  try_terms.template operator()<3>();
  try_terms.template operator()<4>();
  try_terms.template operator()<6>();
  try_terms.template operator()<8>();
  choice.text =
      describe("Phong's power", budget, choice.terms, choice.worst_levels, "the C library's exponential and logarithm");
  return choice;
}

TexelChoice choose_texel_kernel(const Budget& budget) {
  const double worst = RootTexture::worst_levels;
  const std::string start = "texels for " + to_text(budget) + ": ";
  if (budget.unit == Budget::Unit::levels && 2 * worst <= budget.limit) {
    return {true, worst, start + "ten bits for the root of light; at worst " + shown(worst) + " levels"};
  }
  return {false, 0, start + "as they are, decoded by a table"};
}

}  // namespace texmap
