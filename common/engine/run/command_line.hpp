// A program's command line: a table of options, read strictly; and what becomes of errors.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace texmap {

/// A wrong command line; the text names the option and what it takes. Exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws UsageError `why` if the condition holds.
inline void usage_error_if(bool refused, const std::string& why) {
  if (refused) throw UsageError(why);
}

/// The whole of `text` as a whole number.
/// Errors: UsageError with `option` and its range, unless `text` is an optional minus sign and
/// digits in the range.
[[nodiscard]] int parse_whole(std::string_view option, std::string_view text, int low, int high);

/// The whole of `text` as a decimal number such as -0.25 or 1e3, in any locale.
/// Errors: UsageError with `option` and its range, for NaN and infinities too.
[[nodiscard]] double parse_decimal(std::string_view option, std::string_view text, double low,
                                   double high);

/// The words of a list that has | between them.
[[nodiscard]] std::vector<std::string_view> words_between_bars(std::string_view list);

/// The options of a program, and the reader of what the user typed.
/// Errors: logic_error from whoever declares an option's name again, but for `choice`.
class CommandLine {
 public:
  /// Reads what was typed for the option `name`; false if it is none of the option's words.
  /// Errors: UsageError.
  using Read = std::function<bool(const std::string& name, std::string_view typed)>;
  struct Option {
    std::string name;
    std::string placeholder;  ///< N, FILE, or its words with | between them; empty for a flag
    std::string help;
    std::string preset;  ///< the default; may be empty
    Read read;
    std::string unless{};  ///< of a word without an option: the option with which it may be missing
  };

  /// @param program  its name, as typed
  /// @param purpose  one line for the top of the help
  CommandLine(std::string program, std::string purpose);

  /// An option with a whole number from `low` to `high`; without the option `value` stays.
  void whole(std::string_view name, int& value, int low, int high, std::string_view help);
  /// An option with a decimal number from `low` to `high`.
  void decimal(std::string_view name, double& value, double low, double high,
               std::string_view help);
  /// An option with two of them.
  ///
  /// @param placeholder  two letters and what is typed between the numbers, such as UxV
  void pair(std::string_view name, std::string_view placeholder, std::array<double, 2>& values,
            double low, double high, std::string_view help);
  /// An option with a text that must not be empty, such as a file name.
  void text(std::string_view name, std::string_view placeholder, std::string& value,
            std::string_view help);
  /// The same for an option that may be repeated: each adds a text.
  void texts(std::string_view name, std::string_view placeholder, std::vector<std::string>& values,
             std::string_view help);
  /// An option without a value.
  void flag(std::string_view name, bool& value, std::string_view help);
  /// An option with one of a few words, each for a value. Two groups may give one option words:
  /// they are joined, and each group reads its own. The words must live as long as the line.
  template <class Value>
  void choice(std::string_view name, Value& value,
              const std::vector<std::pair<std::string_view, Value>>& words, std::string_view help) {
    std::string listed, preset;
    for (const auto& [word, meaning] : words) {
      if (meaning == value) preset = word;
      listed.append(listed.empty() ? "" : "|").append(word);
    }
    add(name, listed, help, preset, [&value, words](const std::string&, std::string_view typed) {
      for (const auto& [word, meaning] : words) {
        if (word != typed) continue;
        value = meaning;
        return true;
      }
      return false;
    });
  }
  /// The same for an enumeration or a bool of the engine's: its values' words in their order, with
  /// | between them. What a reader may add to gets a list of pairs: places in it would shift.
  template <class Value>
  void choice(std::string_view name, Value& value, std::string_view words, std::string_view help) {
    std::vector<std::pair<std::string_view, Value>> pairs;
    for (const std::string_view word : words_between_bars(words))
      pairs.emplace_back(word, static_cast<Value>(pairs.size()));
    choice(name, value, pairs, help);
  }

  /// An option whose value is anything else.
  ///
  /// @param preset  the default, as text; may be empty
  void add(std::string_view name, std::string_view placeholder, std::string_view help,
           const std::string& preset, const Read& read);

  /// A word without an option, such as a file to read; required, in the order of these calls.
  ///
  /// @param name  its name in the usage line
  /// @param unless  an option with which the word may be left out
  void positional(std::string_view name, std::string& value, std::string_view help,
                  std::string_view unless = "");

  /// The help's text about exit statuses, for programs that make no picture.
  void statuses(std::string_view text);

  /// Reads what the user typed.
  ///
  /// @param words  without the program's name
  /// @return  false after --help or --version, which were answered on stdout
  /// Errors: UsageError.
  [[nodiscard]] bool parse(const std::vector<std::string>& words);
  /// The same for what `main` was called with.
  [[nodiscard]] bool parse(int argc, const char* const* argv);

  /// True when the option was typed; valid after parse().
  [[nodiscard]] bool was_given(std::string_view name) const;

  /// Tells the user what was done to a file of his.
  std::function<void(const std::string& text)> note = [](const std::string&) {};

  /// The options in the order of the help.
  [[nodiscard]] const std::vector<Option>& options() const { return options_; }
  /// The line that shows how the program is called.
  [[nodiscard]] std::string usage() const;
  [[nodiscard]] std::string help() const;

 private:
  [[nodiscard]] std::string call() const;

  std::string program_;
  std::string purpose_;
  std::string statuses_ =
      "0 the picture is written; 1 an error, no picture; 2 the command line is wrong";
  std::vector<Option> options_;
  std::vector<Option> positionals_;
  std::vector<std::string> typed_;
};

/// Makes running out of memory end with a message and status 1. Called before anything else.
void expect_little_memory();
/// Makes a program say what most likely stopped it: a wrong index that the standard library saw.
void expect_wrong_index();

/// What every main program does with errors: calls `body` and turns what it throws into a message
/// on stderr and an exit status: 1 for failures, 2 for a wrong command line.
[[nodiscard]] int run_guarded(const CommandLine& line, const std::function<void()>& body);

}  // namespace texmap
