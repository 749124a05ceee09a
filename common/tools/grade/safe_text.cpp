// Text from students, made safe for terminals, tables and pages.
#include "safe_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "engine/measure/text.hpp"
#include "engine/measure/utf8.hpp"

namespace texmap::grade {
namespace {

bool is_blank(char32_t c) {
  return c == ' ' || c == 0xA0 || (c >= 0x2000 && c <= 0x200D) || c == 0x2028 || c == 0x2029 ||
         c == 0x202F || c == 0x205F || c == 0x2060 || c == 0x3000 || c == 0xFEFF;
}

/// What a formula begins with, also as the wide and small forms of East Asian writing.
bool begins_formula(char32_t c) {
  return c == '=' || c == '+' || c == '-' || c == '@' || c == 0x2212 || c == 0xFF1D ||
         c == 0xFF0B || c == 0xFF0D || c == 0xFF20 || c == 0xFE66 || c == 0xFE62 || c == 0xFE63 ||
         c == 0xFE6B;
}

bool is_wide(char32_t c) {
  return (c >= 0x1100 && c <= 0x115F) || (c >= 0x2E80 && c <= 0xA4CF) ||
         (c >= 0xAC00 && c <= 0xD7A3) || (c >= 0xF900 && c <= 0xFAFF) ||
         (c >= 0xFE30 && c <= 0xFE6F) || (c >= 0xFF00 && c <= 0xFF60) ||
         (c >= 0x1F300 && c <= 0x1FAFF) || (c >= 0x20000 && c <= 0x3FFFD);
}

}  // namespace

std::string clean(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const char32_t c = take_character(text);
    if (c == '\n' || c == '\t' || c == 0x2028 || c == 0x2029) {
      result += ' ';
    } else if (is_harmless(c)) {
      append_utf8(result, c);
    }
  }
  return result;
}

std::string shown_name(std::string_view name) {
  std::string result;
  while (!name.empty()) {
    const auto byte = static_cast<unsigned char>(name[0]);
    const std::size_t size = name.size();
    const char32_t c = take_character(name);
    if (c != replacement_character || size - name.size() > 1) {
      append_utf8(result, c);
    } else if (byte >= 0xA0) {
      append_utf8(result, byte);
    } else {
      result += text("\\x%02X", byte);
    }
  }
  return result;
}

std::string clean_lines(std::string_view text, std::size_t most_characters) {
  std::string result;
  std::size_t characters = 0;
  while (!text.empty()) {
    if (++characters > most_characters) return result + "...";
    const char32_t c = take_character(text);
    if (c == '\n' || is_harmless(c)) append_utf8(result, c);
  }
  return result;
}

std::string csv_cell(std::string_view text) {
  const std::string cleaned = clean(text);
  std::string_view rest = cleaned;
  std::string cell = "\"";
  bool at_start = true;
  while (!rest.empty()) {
    const char32_t c = take_character(rest);
    if (at_start && begins_formula(c)) cell += '\'';
    append_utf8(cell, c);
    if (c == '"') cell += '"';
    at_start = at_start && (is_blank(c) || c == '"');
  }
  return cell + '"';
}

std::string first_word(std::string_view note) {
  return std::string(note.substr(0, std::min(note.find(": "), note.find("; "))));
}

std::string with_word(const std::string& word, const std::string& note) {
  if (note.empty() || word.empty()) return word + note;
  const bool again = note == word || note.starts_with(word + ":") || note.starts_with(word + ";");
  return again ? note : word + ": " + note;
}

std::string file_name_of(std::string_view name) {
  std::string result;
  bool speaks = false;
  for (const char c : name.substr(0, 80)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    speaks = speaks || plain;
    result += plain || c == '-' || c == '_' ? c : '_';
  }
  return speaks ? result : "student";
}

std::string padded(const std::string& text, int columns) {
  int taken = 0;
  for (std::string_view rest = text; !rest.empty();) taken += is_wide(take_character(rest)) ? 2 : 1;
  std::string result = text;
  if (taken < columns) result.append(static_cast<std::size_t>(columns - taken), ' ');
  return result;
}

std::string counted(std::size_t count, const std::string& thing) {
  std::string words = std::to_string(count);
  words.append(" ").append(thing);
  if (count != 1) words += 's';
  return words;
}

}  // namespace texmap::grade
