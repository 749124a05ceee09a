// A module of one chapter: CMake names its header and its class.
#include LIVE_HEADER

namespace texmap::live {

std::unique_ptr<LiveLesson> make_lesson(int /*chapter*/) {
  return std::make_unique<LIVE_CHAPTER>();
}

}  // namespace texmap::live
