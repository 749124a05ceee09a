// The word for a wrong picture, by the pictures that known mistakes draw.
#include "known_words.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <system_error>
#include <thread>

#include "engine/system/file_error.hpp"
#include "process.hpp"

namespace texmap::grade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_loaded = 4;

bool is_current(const fs::path& list, const fs::path& golden) {
  std::error_code error;
  const auto drawn = fs::last_write_time(list, error);
  return !error && drawn >= fs::last_write_time(golden);
}

}  // namespace

std::string KnownWords::words_for(const Item& item, const Image& is, const Image& should) {
  const Known& known = known_for(item, should);
  const std::string words = name_mistake(is, should, known.of_the_whole);
  return words.empty() ? name_mistake(is, should, known.drawn) : words;
}

void KnownWords::draw(const Item& item, const fs::path& folder) const {
  std::fprintf(stderr, "drawing the known mistakes of chapter %s, once; this takes a minute\n",
               item.number.c_str());
  Process process({name_of(program_), item.number, "--out", name_of(folder)});
  while (process.runs() && !stopped_()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

const KnownWords::Known& KnownWords::known_for(const Item& item, const Image& should) {
  const auto known = std::find_if(loaded_.begin(), loaded_.end(),
                                  [&](const Known& one) { return one.item == item.name; });
  if (known != loaded_.end()) {
    loaded_.splice(loaded_.begin(), loaded_, known);
  } else {
    if (loaded_.size() == most_loaded) loaded_.pop_back();
    loaded_.push_front({item.name, mistakes_of_the_whole(should), drawn_for(item)});
  }
  return loaded_.front();
}

std::vector<WrongPicture> KnownWords::drawn_for(const Item& item) const {
  // Without these pictures the grades are the same, and less is said about them.
  try {
    const fs::path folder = folder_ / path_of(item.name);
    const fs::path list = folder / "mistakes.txt";
    if (!is_current(list, item.golden) && fs::exists(program_)) draw(item, folder);
    if (fs::exists(list)) return load_wrong_pictures(folder);
  } catch (const FileError&) {
    std::fprintf(stderr, "the known mistakes of chapter %s cannot be loaded: they are not named\n",
                 item.number.c_str());
  }
  return {};
}

}  // namespace texmap::grade
