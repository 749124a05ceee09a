// Where something is measured, and how it was compiled.
#include "engine/compare/machine.hpp"

#include <thread>

#include "engine/files/system.hpp"
#include "engine/files/text.hpp"

namespace texmap {
namespace {

std::string compiler_name() {
#if defined(__clang__)
  return "clang++ " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#elif defined(_MSC_VER)
  return "Visual C++ " + std::to_string(_MSC_VER);
#else
  return "unknown";
#endif
}

}  // namespace

std::string Machine::text() const {
  std::string line =
      processor + texmap::text(", %d processor%s", processors, processors == 1 ? "" : "s");
  if (load >= 0) line += texmap::text(", load %.1f", load);
  line += "; " + compiler + (flags.empty() ? "" : " " + flags);
  for (const std::string& each : instructions)
    line += (&each == instructions.data() ? "; packs of " : ", ") + each;
  return line;
}

Json Machine::json() const {
  return Json::object({{"processor", processor},
                       {"processors", processors},
                       {"load", load >= 0 ? Json(load) : Json(nullptr)},
                       {"compiler", compiler},
                       {"flags", flags},
                       {"instructions", Json::list({instructions.begin(), instructions.end()})}});
}

Machine this_machine(const std::string& flags, const std::vector<std::string>& instructions) {
  return {processor_name(),
          compiler_name(),
          flags,
          instructions,
          static_cast<int>(std::thread::hardware_concurrency()),
          system_load()};
}

}  // namespace texmap
