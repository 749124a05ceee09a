// JSON, written value by value.
#include "engine/files/json.hpp"

#include <cmath>

#include "engine/files/text.hpp"

namespace texmap {
namespace {

Json enclosed(char open, const std::vector<std::string>& members, char close, bool lines) {
  Json whole = nullptr;
  whole.text = std::string(1, open);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i > 0) whole.text += lines ? "," : ", ";
    if (lines) whole.text += "\n  ";
    for (const char c : members[i]) {  // a line end is never part of a string
      whole.text += c;
      if (c == '\n') whole.text += "  ";
    }
  }
  if (lines && !members.empty()) whole.text += '\n';
  whole.text += close;
  return whole;
}

}  // namespace

Json::Json(double value) : text(std::isfinite(value) ? round_trip(value) : "null") {}

Json::Json(const std::string& value) : text("\"") {
  for (const char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      text += texmap::text("\\u%04x", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  text += '"';
}

Json Json::object(const std::vector<std::pair<const char*, Json>>& members, bool lines) {
  std::vector<std::string> texts;
  texts.reserve(members.size());
  for (const auto& [name, value] : members) texts.push_back(Json(name).text + ": " + value.text);
  return enclosed('{', texts, '}', lines);
}

Json Json::list(const std::vector<Json>& items, bool lines) {
  std::vector<std::string> texts;
  texts.reserve(items.size());
  for (const Json& item : items) texts.push_back(item.text);
  return enclosed('[', texts, ']', lines);
}

}  // namespace texmap
