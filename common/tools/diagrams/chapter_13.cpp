// The computed diagrams of chapter 13: the arc tangent by polynomials.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "diagrams.hpp"
#include "engine/fast/turns.hpp"

namespace texmap::diagrams {
namespace {

/// atan(t) in turns.
double exact_turn(double t) { return std::atan(t) / (2 * std::numbers::pi); }

/// The textbook's series t - t^3/3 + t^5/5 - ..., up to an odd degree, in turns.
double series_turn(int degree, double t) {
  double sum = 0;
  for (int power = degree; power >= 1; power -= 2)
    sum = (power % 4 == 1 ? 1.0 : -1.0) / power + sum * t * t;
  return sum * t / (2 * std::numbers::pi);
}

/// The fit of degree 7, which only a diagram shows.
double fit_of_degree_7(double t) {
  const double z = t * t;
  const double by_z = 0.023278712388082813 - z * 0.0062048964463513895;
  return t * (0.15902981747758406 - z * (0.05111658396932551 - z * by_z));
}

/// A plot: where its lower left corner is, and how long a unit of x and of y.
struct Frame {
  Spot origin;
  double x, y;

  [[nodiscard]] Spot operator()(double px, double py) const {
    return {origin.x + px * x, origin.y - py * y};
  }
};

template <class Function>
void plot(Drawing& d, const Frame& at, const Function& f, double from, double to,
          const std::string& style) {
  std::vector<Spot> through;
  const int pieces = 120;
  for (int i = 0; i <= pieces; ++i) {
    const double x = from + (to - from) * i / pieces;
    through.push_back(at(x, f(x)));
  }
  d.curve(through, style);
}

/// The textbook's series leaves the arc tangent where t is near 1; the fit stays.
Drawing arc_tangent_series() {
  Drawing d{"arc_tangent_series", 640, 330, "The arc tangent, its series and a fit",
            "The arc tangent of t for t from 0 to 1, in turns. The textbook's series of degree 3 "
            "ends below it and that of degree 5 above it. The fitted polynomial of degree 5 lies "
            "on it."};
  const Frame at{{70, 285}, 400, 1700};
  d.arrow(at(0, 0), at(1.08, 0));
  d.arrow(at(0, 0), at(0, 0.158));
  d.text(at(1.1, 0) + Spot{4, 5}, "t", Anchor::start);
  d.text(at(0, 0.158) + Spot{10, 6}, "angle in turns", Anchor::start, "small");
  for (const auto& [t, label] : {std::pair{0.25, "1/4"}, std::pair{0.5, "1/2"},
                                 std::pair{0.75, "3/4"}, std::pair{1.0, "1"}}) {
    d.line(at(t, 0), at(t, 0) + Spot{0, 5});
    d.text(at(t, 0) + Spot{0, 22}, label, Anchor::middle, "small");
  }
  d.line(at(0, 0.125), at(1, 0.125), "soft dashed");
  d.text(at(0, 0.125) + Spot{-8, 5}, "1/8", Anchor::end, "small");
  d.text(at(0, 0) + Spot{-8, 5}, "0", Anchor::end, "small");
  plot(
      d, at, [](double t) { return series_turn(3, t); }, 0, 1, "red dashed");
  plot(
      d, at, [](double t) { return series_turn(5, t); }, 0, 1, "red");
  plot(d, at, exact_turn, 0, 1, "ink thick");
  for (int i = 1; i <= 10; ++i) {
    const double t = i / 10.0;
    d.dot(at(t, eighth_turn<5>(t)), "fill-blue");
  }
  d.text(at(1, series_turn(5, 1)) + Spot{12, 5}, "series of degree 5", Anchor::start, "red small");
  d.text(at(1, 0.125) + Spot{12, 0}, "atan(t), and as dots", Anchor::start, "small");
  d.text(at(1, 0.125) + Spot{12, 17}, "the fit of degree 5", Anchor::start, "blue small");
  d.text(at(1, series_turn(3, 1)) + Spot{12, 5}, "series of degree 3", Anchor::start, "red small");
  return d;
}

/// The error of two fits swings between bounds.
Drawing arc_tangent_error() {
  Drawing d{"arc_tangent_error", 640, 300, "The error of a fitted polynomial",
            "How far the fitted polynomials are from the arc tangent, for t from 0 to 1. The error "
            "of degree 5 swings four times between two bounds, plus and minus 9.7e-5 turns. That "
            "of degree 7 swings five times between bounds a seventh as large."};
  const Frame at{{80, 150}, 420, 105 / fits::ArcTangent<3>::worst};
  const double worst = fits::ArcTangent<3>::worst;
  d.arrow(at(0, 0), at(1.08, 0));
  d.line(at(0, -1.25 * worst), at(0, 1.25 * worst));
  d.text(at(1.1, 0) + Spot{4, 5}, "t", Anchor::start);
  d.text(at(0, 1.25 * worst) + Spot{10, 4}, "error in turns", Anchor::start, "small");
  for (const double side : {-1.0, 1.0}) {
    d.line(at(0, side * worst), at(1.04, side * worst), "soft dashed");
    d.text(at(0, side * worst) + Spot{-8, 5}, side > 0 ? "9.7e-5" : "-9.7e-5", Anchor::end,
           "small");
  }
  d.text(at(0, 0) + Spot{-8, 5}, "0", Anchor::end, "small");
  d.line(at(1, 0), at(1, 0) + Spot{0, 6});
  d.text(at(1, 0) + Spot{10, 20}, "1", Anchor::middle, "small");
  const auto five = [](double t) { return eighth_turn<5>(t) - exact_turn(t); };
  const auto seven = [](double t) { return fit_of_degree_7(t) - exact_turn(t); };
  plot(d, at, five, 0, 1, "blue");
  plot(d, at, seven, 0, 1, "green");
  // The peaks of degree 5: where the error stops to grow, and the right end.
  const double step = 1e-4;
  for (int i = 1; i <= 10000; ++i) {
    const double t = i * step;
    if (i < 10000 && std::abs(five(t)) < std::abs(five(t + step))) continue;
    if (std::abs(five(t)) < std::abs(five(t - step)) || std::abs(five(t)) < worst / 2) continue;
    d.dot(at(t, five(t)), "fill-blue");
  }
  d.text(at(1.04, five(1)) + Spot{12, 5}, "degree 5", Anchor::start, "blue small");
  d.text(at(0.2, 0) + Spot{0, -10}, "degree 7", Anchor::middle, "green small");
  return d;
}

/// What a degree gains: the worst error by degree, of the series and of the fits.
Drawing arc_tangent_degrees() {
  Drawing d{"arc_tangent_degrees", 640, 350, "The worst error by degree",
            "The worst error in texels of a texture 2048 texels wide, for degrees 5 to 35. The "
            "series stays at some ten texels. The fits get about seven times better with every two "
            "degrees, until the rounding of float, or much later that of double, is larger."};
  constexpr double texels = 2048;
  const Frame at{{86, 40}, 12.4, 17};  // x by degree - 4, y by the error's decimal logarithm - 2
  const auto place = [&](int degree, double error) {
    return at(degree - 4, std::log10(error * texels) - 2);
  };
  d.arrow(at(0, -15.4), at(34, -15.4));
  d.line(at(0, -15.4), at(0, 0.6));
  for (int power = 2; power >= -12; power -= 2) {
    const Spot tick = at(0, power - 2);
    d.line(tick, tick - Spot{5, 0});
    const std::string label = power == 0 ? "1" : power == 2 ? "100" : "1e" + std::to_string(power);
    d.text(tick + Spot{-10, 5}, label, Anchor::end, "small");
  }
  for (const int degree : {5, 11, 17, 23, 29, 35}) {
    const Spot tick = at(degree - 4, -15.4);
    d.line(tick, tick + Spot{0, 5});
    d.text(tick + Spot{0, 21}, std::to_string(degree), Anchor::middle, "small");
  }
  d.text(at(34, -15.4) + Spot{8, 10}, "degree", Anchor::start, "small");
  d.text(at(0, 0.6) + Spot{8, -2}, "worst error, texels of 2048", Anchor::start, "small");

  const double in_float = 0.62 * static_cast<double>(std::numeric_limits<float>::epsilon());
  const double in_double = 0.62 * std::numeric_limits<double>::epsilon();
  d.line(place(4, in_float), place(36, in_float), "ink dashed");
  d.text(place(36, in_float) + Spot{6, 5}, "float's rounding", Anchor::start, "small");
  d.line(place(4, in_double), place(36, in_double), "ink dashed");
  d.text(place(36, in_double) + Spot{6, 5}, "double's rounding", Anchor::start, "small");

  std::vector<Spot> series;
  for (int degree = 5; degree <= 35; degree += 2) {
    const double error = std::abs(series_turn(degree, 1) - exact_turn(1));
    series.push_back(place(degree, error));
    d.circle(series.back(), 3, "red");
  }
  d.curve(series, "red dashed");
  d.text(series.back() + Spot{20, 5}, "series", Anchor::start, "red small");

  std::vector<Spot> fitted;
  const auto fit = [&]<int... Degree>(std::integer_sequence<int, Degree...>) {
    fitted = {place(Degree, ArcTangentFit<Degree>::worst)...};
  };
  fit(std::integer_sequence<int, 5, 9, 17, 23, 35>{});
  for (const Spot& spot : fitted) d.dot(spot, "fill-blue");
  d.curve(fitted, "blue");
  d.text(place(23, ArcTangentFit<23>::worst) + Spot{12, -4}, "fitted polynomials", Anchor::start,
         "blue small");
  return d;
}

}  // namespace

std::vector<Drawing> diagrams_of_13() {
  return {arc_tangent_series(), arc_tangent_error(), arc_tangent_degrees()};
}

}  // namespace texmap::diagrams
