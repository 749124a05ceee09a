// A program's command line: a table of options, read strictly; and what becomes of errors.
#include "engine/run/command_line.hpp"

#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

[[noreturn]] void refuse_value(std::string_view option, std::string_view expected,
                               std::string_view typed) {
  throw UsageError(std::string(option) + " takes " + std::string(expected) + ", not '" +
                   std::string(typed) + "'");
}

std::string not_empty(std::string_view typed, const std::string& refusal) {
  if (typed.empty()) throw UsageError(refusal);
  return std::string(typed);
}

/// Whether one of the first words is among the others; each list has | between its words.
bool share_a_word(std::string_view words, std::string_view others) {
  const auto between = [](std::string_view text) { return std::string("|").append(text) += '|'; };
  const std::string listed = between(others);
  const std::vector<std::string_view> all = words_between_bars(words);
  return std::any_of(all.begin(), all.end(), [&](std::string_view word) {
    return listed.find(between(word)) != listed.npos;
  });
}

void complain(const std::string& what) { std::fputs(("error: " + what + "\n").c_str(), stderr); }

/// Called when there is not even the memory to throw an exception.
[[noreturn]] void give_up() {
  if (std::current_exception()) {
    try {
      throw;
    } catch (const std::bad_alloc&) {  // libc++ keeps some memory for this exception
    } catch (...) {
      end_with("error: an exception was thrown where nothing catches it\n");
    }
  }
  end_with("error: not enough memory\n");
}

}  // namespace

std::vector<std::string_view> words_between_bars(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0, end = 0; begin < list.size(); begin = end + 1) {
    end = std::min(list.find('|', begin), list.size());
    words.push_back(list.substr(begin, end - begin));
  }
  return words;
}

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

void CommandLine::add(std::string_view name, std::string_view placeholder, std::string_view help,
                      const std::string& preset, const Read& read) {
  if (!name.starts_with("--"))
    throw std::logic_error("an option begins with --: write --" + std::string(name));
  const auto same = std::find_if(options_.begin(), options_.end(),
                                 [name](const Option& option) { return option.name == name; });
  if (same == options_.end()) {
    options_.push_back(
        {std::string(name), std::string(placeholder), std::string(help), preset, read});
    return;
  }
  const auto has_words = [](std::string_view text) { return text.find('|') != text.npos; };
  if (!has_words(same->placeholder) || !has_words(placeholder) ||
      share_a_word(placeholder, same->placeholder)) {
    throw std::logic_error("the option " + same->name +
                           " is declared twice: each needs a name of its own, such as `.option = "
                           "\"--clouds\"` of a second TextureFile");
  }
  same->placeholder.append("|").append(placeholder);
  same->help.append("; ").append(help);
  same->read = [first = same->read, read](const std::string& option, std::string_view typed) {
    return first(option, typed) || read(option, typed);
  };
}

void CommandLine::whole(std::string_view name, int& value, int low, int high,
                        std::string_view help) {
  add(name, "N", help, std::to_string(value), [&value, low, high](auto& option, auto typed) {
    value = parse_whole(option, typed, low, high);
    return true;
  });
}

void CommandLine::decimal(std::string_view name, double& value, double low, double high,
                          std::string_view help) {
  add(name, "X", help, shown(value), [&value, low, high](auto& option, auto typed) {
    value = parse_decimal(option, typed, low, high);
    return true;
  });
}

void CommandLine::pair(std::string_view name, std::string_view placeholder,
                       std::array<double, 2>& values, double low, double high,
                       std::string_view help) {
  const std::string between(placeholder.substr(1, 1));
  const std::string preset = shown(values[0]) + between + shown(values[1]);
  add(name, placeholder, help, preset,
      [&values, low, high, between, sample = preset](auto& option, auto typed) {
        const std::size_t end = typed.find(between);
        if (end == std::string_view::npos)
          refuse_value(option, "two numbers such as " + sample, typed);
        values = {
            parse_decimal("the first number of " + option, typed.substr(0, end), low, high),
            parse_decimal("the second number of " + option, typed.substr(end + 1), low, high)};
        return true;
      });
}

void CommandLine::text(std::string_view name, std::string_view placeholder, std::string& value,
                       std::string_view help) {
  add(name, placeholder, help, value, [&value](auto& option, auto typed) {
    value = not_empty(typed, option + " needs a name, and got an empty one");
    return true;
  });
}

void CommandLine::texts(std::string_view name, std::string_view placeholder,
                        std::vector<std::string>& values, std::string_view help) {
  add(name, placeholder, help, "", [&values](auto& option, auto typed) {
    values.push_back(not_empty(typed, option + " needs a name, and got an empty one"));
    return true;
  });
}

void CommandLine::flag(std::string_view name, bool& value, std::string_view help) {
  add(name, "", help, "", [&value](auto&, auto) { return value = true; });
}

void CommandLine::positional(std::string_view name, std::string& value, std::string_view help,
                             std::string_view unless) {
  const Read read = [&value](auto& word, auto typed) {
    value = not_empty(typed, word + " must not be empty");
    return true;
  };
  positionals_.push_back({std::string(name), "", std::string(help), "", read, std::string(unless)});
}

void CommandLine::statuses(std::string_view text) { statuses_ = text; }

bool CommandLine::parse(const std::vector<std::string>& words) {
  typed_.clear();
  const auto read = [](const Option& option, std::string_view typed) {
    if (!option.read(option.name, typed)) refuse_value(option.name, option.placeholder, typed);
  };
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
      read(*awaited, word);
      typed_.push_back(awaited++->name);
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
      read(*option, "");
    } else if (equals != std::string_view::npos) {
      read(*option, word.substr(equals + 1));
    } else if (i + 1 < words.size()) {
      read(*option, words[++i]);
    } else {
      throw UsageError(option->name + " needs a value: " + option->name + " " +
                       option->placeholder);
    }
  }
  if (awaited != positionals_.end() && !was_given(awaited->unless))
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
  for (const Option& word : positionals_)
    text += word.unless.empty() ? " " + word.name : " [" + word.name + "]";
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

void expect_little_memory() { std::set_terminate(give_up); }

void expect_wrong_index() {
  const auto handler = [](int signal) {
    std::signal(signal, SIG_DFL);  // ends the program when this returns
    std::fputs(
        "error: the program was stopped, most often because an index is too large: a list of 4 "
        "objects has objects[0] to objects[3]\n",
        stderr);
  };
  std::signal(SIGABRT, handler);
  std::signal(SIGILL, handler);
#ifdef SIGTRAP
  std::signal(SIGTRAP, handler);
#endif
}

int run_guarded(const CommandLine& line, const std::function<void()>& body) {
  secure_standard_streams();
  keep_freed_memory();
  try {
    body();
    return 0;
  } catch (const UsageError& error) {
    complain(std::string(error.what()) + "\n" + line.usage());
    return 2;
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  return 1;
}

}  // namespace texmap
