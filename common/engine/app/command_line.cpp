// A program's command line: a table of options, read strictly.
#include "engine/app/command_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/measure/text.hpp"
#include "engine/system/system.hpp"

namespace texmap {
namespace {

[[noreturn]] void refuse_value(std::string_view option, std::string_view expected,
                               std::string_view typed) {
  throw UsageError(std::string(option) + " takes " + std::string(expected) + ", not '" +
                   std::string(typed) + "'");
}

/// True if `word` is one of the words that `listed` separates by |.
bool has_word(std::string_view listed, std::string_view word) {
  while (!listed.empty()) {
    const std::size_t end = std::min(listed.find('|'), listed.size());
    if (listed.substr(0, end) == word) return true;
    listed.remove_prefix(std::min(end + 1, listed.size()));
  }
  return false;
}

}  // namespace

int parse_whole(std::string_view option, std::string_view text, int low, int high) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high) {
    refuse_value(
        option, "a whole number from " + std::to_string(low) + " to " + std::to_string(high), text);
  }
  return value;
}

double parse_decimal(std::string_view option, std::string_view text, double low, double high) {
  const double value = read_decimal(text).value_or(std::nan(""));
  // Written so that a NaN fails it.
  if (!(value >= low && value <= high)) {
    refuse_value(option, "a number from " + shown(low) + " to " + shown(high), text);
  }
  return value;
}

CommandLine::CommandLine(std::string program, std::string purpose)
    : program_(std::move(program)), purpose_(std::move(purpose)) {}

void CommandLine::add(Option option) {
  const auto same = std::find_if(options_.begin(), options_.end(),
                                 [&option](const Option& o) { return o.name == option.name; });
  if (same == options_.end()) {
    options_.push_back(std::move(option));
    return;
  }
  // Two groups have words for one option: each reads its own.
  const std::string words = same->placeholder + '|' + option.placeholder;
  same->help += "; " + option.help;
  same->read = [first = *same, second = option, words](std::string_view typed) {
    if (!has_word(first.placeholder, typed) && !has_word(second.placeholder, typed))
      refuse_value(first.name, words, typed);
    (has_word(first.placeholder, typed) ? first : second).read(typed);
  };
  same->placeholder = words;
}

void CommandLine::one_of(std::string_view name, const std::vector<std::string_view>& words,
                         std::size_t preset, std::function<void(std::size_t)> choose,
                         std::string_view help) {
  std::string listed;
  for (const std::string_view word : words) {
    if (!listed.empty()) listed += '|';
    listed += word;
  }
  add({std::string(name), listed, std::string(help),
       std::string(preset < words.size() ? words[preset] : ""),
       [words, choose = std::move(choose), listed,
        name = std::string(name)](std::string_view typed) {
         const auto word = std::find(words.begin(), words.end(), typed);
         if (word == words.end()) refuse_value(name, listed, typed);
         choose(static_cast<std::size_t>(word - words.begin()));
       }});
}

void CommandLine::whole(std::string_view name, int& value, int low, int high,
                        std::string_view help) {
  add({std::string(name), "N", std::string(help), std::to_string(value),
       [&value, low, high, name = std::string(name)](std::string_view typed) {
         value = parse_whole(name, typed, low, high);
       }});
}

void CommandLine::decimal(std::string_view name, double& value, double low, double high,
                          std::string_view help) {
  add({std::string(name), "X", std::string(help), shown(value),
       [&value, low, high, name = std::string(name)](std::string_view typed) {
         value = parse_decimal(name, typed, low, high);
       }});
}

void CommandLine::text(std::string_view name, std::string_view placeholder, std::string& value,
                       std::string_view help) {
  add({std::string(name), std::string(placeholder), std::string(help), value,
       [&value, name = std::string(name)](std::string_view typed) {
         if (typed.empty()) throw UsageError(name + " needs a name, and got an empty one");
         value = typed;
       }});
}

void CommandLine::texts(std::string_view name, std::string_view placeholder,
                        std::vector<std::string>& values, std::string_view help) {
  add({std::string(name), std::string(placeholder), std::string(help), "",
       [&values, name = std::string(name)](std::string_view typed) {
         if (typed.empty()) throw UsageError(name + " needs a name, and got an empty one");
         values.emplace_back(typed);
       }});
}

void CommandLine::flag(std::string_view name, bool& value, std::string_view help) {
  add({std::string(name), "", std::string(help), "", [&value](std::string_view) { value = true; }});
}

void CommandLine::positional(std::string_view name, std::string& value, std::string_view help) {
  positionals_.push_back({std::string(name), "", std::string(help), "",
                          [&value, name = std::string(name)](std::string_view typed) {
                            if (typed.empty()) throw UsageError(name + " must not be empty");
                            value = typed;
                          }});
}

void CommandLine::positionals(std::string_view name, std::vector<std::string>& values,
                              std::string_view help) {
  positionals_.push_back({std::string(name), "", std::string(help), "",
                          [&values, name = std::string(name)](std::string_view typed) {
                            if (typed.empty()) throw UsageError(name + " must not be empty");
                            values.emplace_back(typed);
                          }});
  last_repeats_ = true;
}

void CommandLine::statuses(std::string_view text) { statuses_ = text; }

bool CommandLine::parse(const std::vector<std::string>& words) {
  typed_.clear();
  auto awaited = positionals_.begin();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (word == "--help" || word == "-h") {
      print(help());
      return false;
    }
    if (word == "--version") {
      print(program_ + " " TEXMAP_VERSION " (Texture Mapping, Step by Step)\n");
      return false;
    }
    if (awaited != positionals_.end() && word.substr(0, 1) != "-") {
      awaited->read(word);
      typed_.push_back(awaited->name);
      if (!last_repeats_ || awaited + 1 != positionals_.end()) ++awaited;
      continue;
    }
    // --name=value is the same as --name value.
    const auto equals = word.substr(0, 2) == "--" ? word.find('=') : std::string_view::npos;
    const std::string_view name = word.substr(0, equals);
    const auto option = std::find_if(options_.begin(), options_.end(),
                                     [name](const Option& o) { return o.name == name; });
    if (option == options_.end()) {
      throw UsageError(word.substr(0, 1) == "-"
                           ? "there is no option " + std::string(name)
                           : "'" + std::string(word) + "' is not an option; options begin with --");
    }
    typed_.emplace_back(name);
    if (option->placeholder.empty()) {
      if (equals != std::string_view::npos) throw UsageError(option->name + " takes no value");
      option->read("");
    } else if (equals != std::string_view::npos) {
      option->read(word.substr(equals + 1));
    } else if (i + 1 < words.size()) {
      option->read(words[++i]);
    } else {
      throw UsageError(option->name + " needs a value: " + option->name + " " +
                       option->placeholder);
    }
  }
  if (awaited != positionals_.end() && !was_given(awaited->name))
    throw UsageError(awaited->name + " is missing");
  return true;
}

bool CommandLine::parse(int argc, const char* const* argv) {
  return parse(typed_words(argc, argv));
}

bool CommandLine::was_given(std::string_view name) const {
  return std::find(typed_.begin(), typed_.end(), name) != typed_.end();
}

std::string CommandLine::call() const {
  std::string text = "usage: " + program_;
  for (const Option& word : positionals_) text += " " + word.name;
  if (last_repeats_) text += "...";
  return text + " [options]";
}

std::string CommandLine::usage() const {
  return call() + "     (" + program_ + " --help lists them)";
}

std::string CommandLine::help() const {
  std::string text = program_ + ": " + purpose_ + "\n\n" + call() + "\n\n";
  constexpr std::size_t indent = 34;
  constexpr std::size_t columns = 100;
  const auto line = [&text](const std::string& left, const std::string& right) {
    std::string row = "  " + left;
    if (row.size() + 2 > indent) {
      text += row + "\n";
      row.clear();
    }
    row.resize(indent, ' ');
    for (std::size_t begin = 0, end = 0; begin < right.size(); begin = end + 1) {
      end = std::min(right.find(' ', begin), right.size());
      const std::string word = right.substr(begin, end - begin);
      if (row.size() + word.size() > columns && row.size() > indent) {
        row.pop_back();
        text += row + "\n";
        row.assign(indent, ' ');
      }
      row += word + " ";
    }
    row.pop_back();
    text += row + "\n";
  };
  for (const Option& word : positionals_) line(word.name, word.help);
  for (const Option& option : options_) {
    const std::string preset = option.preset.empty() ? "" : " (default: " + option.preset + ")";
    line(option.placeholder.empty() ? option.name : option.name + " " + option.placeholder,
         option.help + preset);
  }
  line("--help", "show this help and stop");
  line("--version", "show the version and stop");
  text += "\nexit status: " + statuses_ + "\n";
  return text;
}

}  // namespace texmap
