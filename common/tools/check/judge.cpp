// Judges the values of a function, whatever their type.
#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "engine/files/text.hpp"

namespace texmap::check {
namespace {

/// A value as the verdict prints it: "0.25", "(0.25, 0.5)", "yes".
std::string printed(const Value& value, const Kind& kind, int digits) {
  if (kind.form == Kind::yes_or_no) return value.numbers[0] != 0 ? "yes" : "no";
  if (kind.form == Kind::whole) return text("%.0f", value.numbers[0]);
  if (kind.form == Kind::number) return in_words(value.numbers[0], digits);
  std::string words;
  for (const double part : value.parts())
    words += (words.empty() ? "(" : ", ") + in_words(part, digits);
  return words + ")";
}

/// Whether one of the numbers that values consist of is the same at every place.
bool agree(const std::vector<Value>& a, const std::vector<Value>& b, std::size_t part) {
  return std::equal(a.begin(), a.end(), b.begin(), [=](const Value& x, const Value& y) {
    return alike(x.numbers[part], y.numbers[part]);
  });
}

/// What happens to any value of several numbers: two of them are exchanged, one is a copy of
/// another, has the wrong sign or is missing.
SlipTable slips_of_parts(const Value& right, const Kind& kind) {
  SlipTable slips;
  const auto add = [&](const std::string& word, std::size_t i, double of_i, std::size_t k,
                       double of_k) {
    Value value = right;
    value.numbers[i] = of_i;
    value.numbers[k] = of_k;
    slips.add({word, {value}});
  };
  const auto& all = right.numbers;
  for (std::size_t i = 0; i < right.count; ++i) {
    const std::string name = kind.names[i];
    add("the sign of " + name + " is wrong", i, -all[i], i, -all[i]);
    add(name + " is missing, 0 everywhere", i, 0, i, 0);
    for (std::size_t k = 0; k < right.count; ++k) {
      if (k == i) continue;
      if (i < k) add(name + " and " + kind.names[k] + " are exchanged", i, all[k], k, all[i]);
      add(name + " is a copy of " + kind.names[k], i, all[k], k, all[k]);
    }
  }
  return slips;
}

/// A mistake in one number of several, such as u, while the others are right or have mistakes of
/// their own: the words of those rows that are wrong in this number alone.
std::string mistakes_in_parts(const std::vector<Value>& right, const std::vector<Value>& values,
                              const std::vector<Slip>& known) {
  std::string words;
  const std::size_t count = right[0].count;
  for (std::size_t part = 0; part < count; ++part) {
    for (const Slip& slip : known) {
      bool explains = agree(values, slip.values, part) && !agree(right, slip.values, part);
      for (std::size_t other = 0; other < count; ++other)
        explains = explains && (other == part || agree(right, slip.values, other));
      if (!explains) continue;
      if (words.find(slip.word) == std::string::npos)
        words += (words.empty() ? "" : "; and ") + slip.word;
      break;
    }
  }
  return words;
}

/// "2 times the right value at every place", if it is, or empty.
std::string factor_of(const std::vector<Value>& right, const std::vector<Value>& values) {
  double factor = 0;
  bool is_known = false;
  for (std::size_t i = 0; i < right.size(); ++i) {
    for (std::size_t part = 0; part < right[i].count; ++part) {
      const double of_right = right[i].numbers[part], yours = values[i].numbers[part];
      if (!is_known && !alike(of_right, 0.0)) {
        factor = yours / of_right;
        is_known = true;
      }
      if (!alike(factor * of_right, yours)) return "";
    }
  }
  if (factor == 0 || !std::isfinite(factor)) return "";
  return in_words(factor, 4) + " times the right value at every place";
}

/// What is to be seen in wrong values, whatever the mistake is.
std::string fact_of(const std::vector<Value>& right, const std::vector<Value>& values,
                    const Kind& kind) {
  std::string good, bad;
  bool is_nan = false;
  for (std::size_t part = 0; part < right[0].count; ++part) {
    (agree(right, values, part) ? good : bad) += std::string(" ") + kind.names[part];
    for (const Value& value : values) is_nan = is_nan || std::isnan(value.numbers[part]);
  }
  if (is_nan) return "there is no number in it (NaN): the root of one below 0, 0 / 0, acos of 2";
  const auto as_first = [&](const Value& value) { return alike(value, values[0]); };
  if (std::all_of(values.begin(), values.end(), as_first))
    return "it is the same at every place, whatever your function gets";
  return good.empty() ? "" : "right at every place:" + good + "; wrong:" + bad;
}

/// Fills in what is said of the first value that is wrong.
void tell(Verdict& verdict, const Trial::At& at, const Value& value, const Kind& kind) {
  verdict.right = false;
  verdict.law = at.law;
  for (const int digits : {6, 9, 17}) {  // more where they would look equal
    verdict.expected = printed(at.right, kind, digits);
    verdict.got = printed(value, kind, digits);
    if (verdict.expected != verdict.got) break;
  }
  if (at.count > 0 && (value.numbers[0] < 0 || value.numbers[0] >= at.count))
    verdict.got += text(", outside: there are 0 to %d", at.count - 1);
}

}  // namespace

std::string in_words(double value, int digits) {
  if (std::isnan(value)) return "no number (NaN)";
  if (std::isinf(value)) return value > 0 ? "infinity" : "-infinity";
  if (std::abs(value) < 1e-15) return "0";  // -0, or what rounding leaves of 0
  const bool whole = value == std::floor(value) && std::abs(value) < 1e15;
  return whole ? text("%.0f", value) : text("%.*g", digits, value);
}

double apart(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

bool alike(const Value& a, const Value& b) {
  double size = 1, largest = 0;
  for (std::size_t i = 0; i < a.count; ++i) {
    size = std::max(size, std::abs(a.numbers[i]));
    largest = std::max(largest, apart(a.numbers[i], b.numbers[i]));
  }
  return largest <= 1e-6 * (std::isfinite(size) ? size : 1);
}
bool alike(double a, double b) { return alike(value_of(a), value_of(b)); }

SlipTable::SlipTable() = default;
SlipTable::SlipTable(std::string_view word, std::initializer_list<Value> values)
    : rows{{std::string(word), values}} {}
SlipTable::SlipTable(const SlipTable&) = default;
SlipTable& SlipTable::operator=(const SlipTable&) = default;
SlipTable::~SlipTable() = default;

void SlipTable::add(const SlipTable& more) {
  rows.insert(rows.end(), more.rows.begin(), more.rows.end());
}

void SlipTable::add_rule(std::string_view rule) {
  for (Slip& row : rows) (row.word += row.word.empty() ? "" : ": ") += rule;
}

void add_place(std::vector<Slip>& all, const SlipTable& table) {
  std::size_t row = 0;
  for (const Slip& slip : table.rows) {
    for (const Value& value : slip.values) {
      if (row == all.size()) all.push_back({slip.word, {}});
      all[row++].values.push_back(value);
    }
  }
}

Verdict judge(const Trial& trial, const std::vector<Value>& values) {
  Verdict verdict;
  verdict.places = values.size();
  verdict.values = bytes_of(values);
  const auto seen = [&trial](const Value& value, std::size_t place) {
    return trial.seen ? trial.seen(value, place) : value;
  };
  std::vector<Value> all_right, yours;
  std::string edge;
  std::vector<Slip> of_parts;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Trial::At& at = trial.places[i];
    if (trial.kind.form == Kind::list) add_place(of_parts, slips_of_parts(at.right, trial.kind));
    all_right.push_back(seen(at.right, i));
    yours.push_back(seen(values[i], i));
    if (alike(all_right.back(), yours.back())) continue;
    edge = verdict.right || edge == at.edge ? at.edge : "";
    if (verdict.right) tell(verdict, at, values[i], trial.kind);
    ++verdict.wrong;
  }
  if (verdict.right) return verdict;
  std::vector<Slip> known = trial.slips;
  known.insert(known.end(), of_parts.begin(), of_parts.end());
  for (Slip& slip : known)
    for (std::size_t i = 0; i < values.size(); ++i) slip.values[i] = seen(slip.values[i], i);
  for (const Slip& slip : known) {
    const auto same = [](const Value& a, const Value& b) { return alike(a, b); };
    if (!std::equal(yours.begin(), yours.end(), slip.values.begin(), same)) continue;
    verdict.mistake = slip.word;
    break;
  }
  if (verdict.mistake.empty()) verdict.mistake = edge;
  if (trial.kind.form == Kind::yes_or_no) return verdict;
  verdict.fact = factor_of(all_right, yours);
  if (!verdict.mistake.empty()) return verdict;
  verdict.mistake = mistakes_in_parts(all_right, yours, known);
  verdict.in_parts = !verdict.mistake.empty();
  if (!verdict.in_parts && verdict.fact.empty())
    verdict.fact = fact_of(all_right, yours, trial.kind);
  return verdict;
}

std::string bytes_of(const std::vector<Value>& values) {
  std::string bytes;
  for (const Value& value : values) {
    bytes.append(reinterpret_cast<const char*>(value.numbers.data()), value.count * sizeof(double));
  }
  return bytes;
}

std::vector<Value> values_from(const std::string& bytes, const Trial& trial) {
  std::vector<Value> values;
  const char* at = bytes.data();
  for (const Trial::At& place : trial.places) {
    Value value{.count = place.right.count};
    const std::size_t size = value.count * sizeof(double);
    if (at + size > bytes.data() + bytes.size())
      throw std::runtime_error("there are too few values");
    std::memcpy(value.numbers.data(), at, size);
    at += size;
    values.push_back(value);
  }
  return values;
}

}  // namespace texmap::check
