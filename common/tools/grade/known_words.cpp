// The word for a wrong picture, by the pictures that known mistakes draw.
#include "known_words.hpp"

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
  // Mistakes in the whole picture need no drawing.
  const std::string words = name_mistake(is, should, mistakes_of_the_whole(should));
  return words.empty() ? name_mistake(is, should, drawn_for(item)) : words;
}

void KnownWords::draw(const Item& item, const fs::path& folder) const {
  std::fprintf(stderr, "drawing the known mistakes of chapter %s, once; this takes a minute\n",
               item.number.c_str());
  Process process({name_of(program_), item.number, "--out", name_of(folder)});
  while (process.runs() && !stopped_()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

const std::vector<WrongPicture>& KnownWords::drawn_for(const Item& item) {
  for (auto one = loaded_.begin(); one != loaded_.end(); ++one) {
    if (one->item != item.name) continue;
    loaded_.splice(loaded_.begin(), loaded_, one);
    return one->wrong;
  }
  loaded_.push_front({item.name, {}});
  if (loaded_.size() > most_loaded) loaded_.pop_back();
  // Without these pictures the grades are the same, and less is said about them.
  try {
    const fs::path folder = folder_ / path_of(item.name);
    const fs::path list = folder / "mistakes.txt";
    if (!is_current(list, item.golden) && fs::exists(program_)) draw(item, folder);
    if (fs::exists(list)) loaded_.front().wrong = load_wrong_pictures(folder);
  } catch (const FileError&) {
    loaded_.front().wrong.clear();
  }
  return loaded_.front().wrong;
}

}  // namespace texmap::grade
