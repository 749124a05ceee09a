// Numbers in sentences.
#include "engine/files/text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <locale>
#include <sstream>

namespace texmap {
namespace {

/// [+-] digits [. digits] [e [+-] digits], with a digit before or after the point.
bool is_decimal(std::string_view text) {
  const auto take = [&text](std::string_view any_of) {
    const bool found = !text.empty() && any_of.find(text.front()) != std::string_view::npos;
    if (found) text.remove_prefix(1);
    return found;
  };
  const auto take_digits = [&] {
    bool any = false;
    while (take("0123456789")) any = true;
    return any;
  };
  take("+-");
  bool good = take_digits();
  if (take(".")) good = take_digits() || good;
  if (good && take("eE")) {
    take("+-");
    good = take_digits();
  }
  return good && text.empty();
}

}  // namespace

#ifdef __EMSCRIPTEN__  // a page has the C locale alone, and streams would double its size
namespace {
/// JavaScript's Number(text). The C library's would bring the arithmetic of long double along.
__attribute__((import_module("page"), import_name("number"))) extern "C" double page_number(
    const char* text);
double read_number(const std::string& text, bool&) { return page_number(text.c_str()); }
}  // namespace

std::string shown(double value, int digits) { return text("%.*g", digits, value); }
#else
namespace {
double read_number(const std::string& text, bool& fails) {
  std::istringstream in{text};
  in.imbue(std::locale::classic());
  double value = 0;
  in >> value;
  fails = in.fail();
  return value;
}
}  // namespace

std::string shown(double value, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  out << value;
  return out.str();
}
#endif

std::optional<double> read_decimal(std::string_view text) {
#if defined(__cpp_lib_to_chars) && !defined(__EMSCRIPTEN__)
  // Much faster than a stream. What it does not take (too large, too small) the stream judges.
  const std::size_t sign = text.find_first_not_of("+-") == 1 ? 1 : 0;
  const char* const end = text.data() + text.size();
  double number = 0;
  if (text.find_first_of("0123456789.", sign) == sign) {
    const auto [stopped, error] = std::from_chars(text.data() + sign, end, number);
    if (error == std::errc() && stopped == end) return text.front() == '-' ? -number : number;
  }
#endif
  if (!is_decimal(text)) return {};
  bool fails = false;
  const double value = read_number(std::string(text), fails);
  if (fails && std::abs(value) > 1) return {};  // a number that is too small is 0
  return value;
}

std::string round_trip(double value) {
  for (const int digits : {15, 16}) {
    std::string text = shown(value, digits);
    if (read_decimal(text) == value) return text;
  }
  return shown(value, 17);
}

std::string text(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  std::va_list again;
  va_copy(again, values);
  const int length = std::vsnprintf(nullptr, 0, format, values);
  va_end(values);
  std::string result(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
  std::vsnprintf(result.data(), result.size() + 1, format, again);
  va_end(again);
  return result;
}

std::string quoted(std::string_view piece, std::size_t most) {
  std::string shown = "'";
  for (const char c : piece.substr(0, most)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (piece.size() > most ? "...'" : "'");
}

std::string escaped_markup(const std::string& plain) {
  constexpr std::string_view special = "&<>\"";
  constexpr std::array escapes = {"&amp;", "&lt;", "&gt;", "&quot;"};
  std::string markup;
  for (const char c : plain) {
    const std::size_t i = special.find(c);
    markup += i == special.npos ? std::string(1, c) : escapes[i];
  }
  return markup;
}

}  // namespace texmap
