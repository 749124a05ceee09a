// The options --trade and --extremes.
#include "engine/run/trade.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

#include "engine/compare/difference.hpp"
#include "engine/compare/trade.hpp"
#include "engine/draw/number_names.hpp"
#include "engine/draw/progress.hpp"
#include "engine/files/save_png.hpp"
#include "engine/files/system.hpp"
#include "engine/files/text.hpp"
#include "engine/run/chosen.hpp"
#include "engine/run/command_line.hpp"
#include "sampling/sampler_kind.hpp"

namespace texmap {
namespace {

using Words = std::vector<std::string>;

/// Words as a shell reads them.
std::string joined(const Words& words) {
  std::string all;
  for (std::string word : words) {
    const std::string_view plain = "-=_./,:+%@";
    const bool is_plain = std::all_of(word.begin(), word.end(), [plain](unsigned char c) {
      return std::isalnum(c) != 0 || c >= 0x80 || plain.find(static_cast<char>(c)) != plain.npos;
    });
    if (!is_plain || word.empty()) {
      for (std::size_t at = 0; (at = word.find('\'', at)) != word.npos; at += 4)
        word.replace(at, 1, R"('\'')");
      word.insert(word.begin(), '\'');
      word += '\'';
    }
    all += (all.empty() ? "" : " ") + word;
  }
  return all;
}

/// The words of an option that takes one of a few; none if the program has no such option.
Words choices_of(const CommandLine& line, std::string_view name) {
  Words choices;
  for (const CommandLine::Option& option : line.options()) {
    if (option.name != name) continue;
    for (const std::string_view word : words_between_bars(option.placeholder))
      choices.emplace_back(word);
  }
  return choices;
}

/// The words without an option and its value, or without a flag.
Words without(const Words& words, const std::string& option, bool has_value = true) {
  Words left;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option) {
      i += has_value ? 1U : 0U;
    } else if (!words[i].starts_with(option + "=")) {
      left.push_back(words[i]);
    }
  }
  return left;
}

/// The parts of a trade as they are collected.
class Collector {
 public:
  Collector(const CommandLine& line, const Words& words, const DrawingBy& drawing)
      : line_(line), drawing_(drawing), typed_(without(words, "--threads")) {
    for (const char* flag : {"--trade", "--extremes", "--quiet"})
      typed_ = without(typed_, flag, false);
  }

  [[nodiscard]] Words choices(const std::string& option) const {
    return line_.was_given(option) ? Words() : choices_of(line_, option);
  }
  /// What the user typed, but for what is the same for all.
  [[nodiscard]] const Words& typed() const { return typed_; }

  /// What draws the picture by what was typed and these words.
  [[nodiscard]] std::function<Image()> draw(const Words& more) const {
    Words words = typed_;
    for (const std::string& word : more) {
      if (word.starts_with("--")) words = without(words, word);
    }
    words.insert(words.end(), more.begin(), more.end());
    words.insert(words.end(), {"--threads", "1", "--quiet"});
    return drawing_(words);
  }
  /// Adds a way; says why where its words do not go together with the others.
  void add(TradePart& part, const Words& more) {
    try {
      Way way{more.empty() ? "as typed" : joined(more), draw(more)};
      if (way.words.starts_with("--budget")) static_cast<void>(way.draw());  // some are refused
      part.ways.push_back(std::move(way));
    } catch (const UsageError& error) {
      refused = error.what();
    }
  }
  std::string refused;  ///< why the last way that was refused was

 private:
  const CommandLine& line_;
  const DrawingBy& drawing_;
  Words typed_;
};

/// Numbers, formulas and budgets, which should all draw what plain double draws.
TradePart same_picture(Collector& collect, const std::vector<Instructions>& packs) {
  const Words numbers = collect.choices("--number");
  const Words base = numbers.empty() ? Words() : Words{"--number", "double"};
  TradePart part{
      "The same picture: what differs from the first way's is an error", collect.draw(base), {}};
  collect.add(part, base);
  for (const std::string& number : numbers) {
    if (number == "double" || number == "interval") continue;
    if (!number.ends_with("-pack")) {
      collect.add(part, {"--number", number});
      continue;
    }
    for (const Instructions each : packs)
      collect.add(part, {"--number", number, "--instructions", name_of(each)});
  }
  for (const std::string& form : collect.choices("--spheres")) {
    if (form == "robust") continue;
    Words words = base;
    words.insert(words.end(), {"--spheres", form});
    collect.add(part, words);
  }
  if (!collect.choices("--budget").empty() && collect.choices("--filter").empty()) {
    for (const char* budget : {"texels=0.01", "texels=0.1", "levels=1", "levels=4"})
      collect.add(part, {"--budget", budget});
  }
  return part;
}

/// Samples, samplers, filters and ways to light, which should all come near the same picture.
std::optional<TradePart> noise(Collector& collect, const CommandLine& line, int samples) {
  const Words samplers = collect.choices("--sampler");
  const Words filters =  // a budget chooses the filter
      line.was_given("--budget") ? Words() : collect.choices("--filter");
  const auto many = [&](Words words, int times) {
    words.insert(words.end(), {"--samples", std::to_string(times)});
    return words;
  };
  TradePart part{"", {}, {}};
  if (choices_of(line, "--sampler").empty()) {
    const Words nearest = filters.empty() ? Words() : Words{"--filter", "nearest"};
    part.title = "Samples" + std::string(filters.empty() ? "" : " and filters") +
                 ": what differs from 256 samples a pixel is an error" +
                 (filters.empty() ? "" : ", also at outlines, where no filter helps");
    part.right = collect.draw(many(nearest, 256));
    for (const int each : std::set{1, 4, 16, samples}) collect.add(part, many(nearest, each));
    for (const std::string& filter : filters) {
      if (filter != "nearest") collect.add(part, {"--filter", filter});
    }
    if (!filters.empty() && !collect.choices("--budget").empty()) {  // it chooses the filter
      for (const char* budget : {"levels=1", "levels=4"}) collect.add(part, {"--budget", budget});
    }
    return part;
  }
  if (line.was_given("--target-error")) return {};
  const int right = std::min(16 * samples, most_samples);
  part.title = "Noise: what differs from " + std::to_string(right) +
               " samples a pixel, by another seed, is an error";
  Words other = many({}, right);
  if (!line.was_given("--seed")) other.insert(other.end(), {"--seed", "1"});
  part.right = collect.draw(other);
  for (const int each : {samples, std::max(samples / 4, 1), 4 * samples}) {
    const bool is_new = each != samples || part.ways.empty();
    if (is_new && each <= right) collect.add(part, many({}, each));
  }
  for (const std::string& sampler : samplers) collect.add(part, {"--sampler", sampler});
  for (const std::string& light : collect.choices("--light")) collect.add(part, {"--light", light});
  return part;
}

}  // namespace

void show_trade(const Chosen& chosen, const CommandLine& line, const Words& words,
                const std::vector<Instructions>& packs, const DrawingBy& drawing) {
  usage_error_if(line.was_given("--time-limit"),
                 "--time-limit stops a slow way after fewer samples, so --trade would compare "
                 "other pictures: give --samples in its place");
  usage_error_if(chosen.settings.number == NumberKind::interval,
                 "--number interval draws how certain the colors are, and --trade compares "
                 "colors: leave one of them out");
  std::filesystem::path file = path_of(chosen.settings.out);
  if (!is_stream(file)) file = file.replace_extension() += "_trade.svg";
  check_output(file);
  Collector collect(line, words, drawing);
  std::vector<TradePart> parts{same_picture(collect, packs)};
  if (std::optional<TradePart> other = noise(collect, line, chosen.settings.samples))
    parts.push_back(std::move(*other));
  const std::string number = name_of(path_of(chosen.chapter).filename()).substr(0, 2);
  const std::string typed = joined(without(collect.typed(), "--out"));
  const std::string command = "./course run " + number + (typed.empty() ? "" : " " + typed);
  {
    Progress progress(!chosen.settings.quiet);
    measure_trade(parts, 15, [&](int done, int all) { progress.report(done, all); });
  }
  std::string said;
  for (const TradePart& part : parts)
    said += table_of(part, command) + recommendation(part, command) + "\n";
  if (!collect.refused.empty()) said += "Not measured: " + collect.refused + "\n";
  if (choices_of(line, "--budget").empty())
    said += "No --budget: this program has no shorter formulas to choose from\n";
  write_text_atomically(file, plot_of(parts, command));
  print(said + "Time across and error up: " + name_of(file) + "\n");
}

void show_extremes(const Chosen& chosen, bool has_float, const DrawScene& draw) {
  for (const char* option : {"--number", "--budget", "--time-limit", "--target-error"}) {
    usage_error_if(chosen.was_given(option),
                   std::string("--extremes chooses numbers, formulas and samples itself: leave "
                               "out ") +
                       option);
  }
  Progress progress(!chosen.settings.quiet);
  const Image right = draw(false, 1, 0);
  constexpr int decades = 20;
  const auto limits = std::array{1.0 / static_cast<double>(right.pixels.size()), 0.01, 0.25};
  std::string lines = text(
      "%d x %d pixels; a pixel differs by more than one level from that in "
      "double, near the origin, in the lesson's size\n"
      "                          a pixel  1 %% of them   a quarter\n",
      right.width, right.height);
  const struct {
    const char* words;
    double factor;
    bool moves;
  } ladders[] = {{"everything smaller", 0.1, false},
                 {"everything larger", 10, false},
                 {"everything moved by", 10, true}};
  const int pictures = (has_float ? 6 : 3) * (decades + 1);
  int done = 0;
  for (const bool in_float : {true, false}) {
    if (in_float && !has_float) continue;
    for (const auto& ladder : ladders) {
      std::array<std::string, 3> first;
      for (int decade = 0; decade <= decades && first.back().empty(); ++decade) {
        const double at = std::pow(ladder.factor, decade);
        const double moved = decade == 0 ? 0 : at / 10;  // from 1 on
        const Image image = ladder.moves ? draw(in_float, 1, moved) : draw(in_float, at, 0);
        const Figures figures = measure(right, image, {}, Detail::pixels);
        const double share = static_cast<double>(pixels_off_by_more_than(figures, 1)) /
                             static_cast<double>(figures.pixels_compared);
        for (std::size_t i = 0; i < first.size(); ++i) {
          if (share >= limits[i] && first[i].empty())
            first[i] = decade == 0 ? "at once" : text("%g", ladder.moves ? moved : at);
        }
        progress.report(++done, pictures);
      }
      lines += text("%-6s %-20s", in_float ? "float" : "double", ladder.words);
      for (const std::string& each : first)
        lines += text("  %10s", each.empty() ? "never" : each.c_str());
      lines += "\n";
    }
  }
  print(lines + text("never: not by %d powers of ten. The way to find out why: --number interval, "
                     "where a chapter has it,\nshows the pixels that rounding could change, and "
                     "chapter 14 the usual causes\n",
                     decades));
}

}  // namespace texmap
