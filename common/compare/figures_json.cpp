// The figures of a comparison for other programs.
#include "figures_json.hpp"

#include <cmath>
#include <locale>
#include <sstream>

namespace texmap {
namespace {

std::ostream& operator<<(std::ostream& out, Rgb8 color) {
  return out << '[' << int{color.r} << ", " << int{color.g} << ", " << int{color.b} << ']';
}

std::ostream& operator<<(std::ostream& out, const Box& box) {
  return out << R"({"left": )" << box.left << R"(, "top": )" << box.top << R"(, "width": )" << box.width << R"(, "height": )"
             << box.height << '}';
}

std::ostream& operator<<(std::ostream& out, const WorstPixel& worst) {
  return out << R"({"levels": )" << worst.levels << R"(, "column": )" << worst.column << R"(, "row": )" << worst.row
             << R"(, "a": )" << worst.a << R"(, "b": )" << worst.b << '}';
}

/// The value as JSON, or null.
template <class Value>
std::string json(const Value& value, bool is_there = true) {
  if (!is_there) return "null";
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << value;
  return out.str();
}

}  // namespace

std::string round_trip(double value) {
  std::string text;
  for (const int digits : {15, 16, 17}) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << value;
    text = out.str();
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double read = 0;
    if (in >> read && read == value) break;
  }
  return text;
}

std::string figures_json(const Figures& figures) {
  const bool differ = figures.pixels_different > 0;
  const bool finite = std::isfinite(figures.peak_signal_to_noise);
  std::string text;
  const auto line = [&text](const char* name, const std::string& value) {
    text += text.empty() ? "{\n  \"" : ",\n  \"";
    text += name;
    text += "\": ";
    text += value;
  };
  line("width", json(figures.width));
  line("height", json(figures.height));
  line("pixels_compared", json(figures.pixels_compared));
  line("pixels_different", json(figures.pixels_different));
  line("share_different", round_trip(figures.share_different));
  line("box", json(figures.box, differ));
  line("largest_difference", json(figures.worst, differ));
  line("mean_absolute_error", round_trip(figures.mean_absolute_error));
  line("root_mean_square_error", round_trip(figures.root_mean_square_error));
  line("psnr", finite ? "\"finite\"" : "\"infinite\"");
  line("psnr_db", finite ? round_trip(figures.peak_signal_to_noise) : "null");
  line("ssim", round_trip(figures.structural_similarity));
  line("flip", round_trip(figures.flip));
  line("mean_a", round_trip(figures.mean_a));
  line("mean_b", round_trip(figures.mean_b));
  return text + "\n}\n";
}

}  // namespace texmap
