// Runs a fuzz target once on every file of some folders, without libFuzzer.
#include <cstdio>

#include "fuzz/target.hpp"
#include "support/temporary_folder.hpp"

// Targets with a mutator refer to it; nothing is changed here.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) {
  return size;
}

int main(int argc, char** argv) {
  int runs = 0;
  for (int i = 1; i < argc; ++i) {
    std::error_code missing;  // a target without a find has no folder of finds
    for (const auto& entry : std::filesystem::directory_iterator(argv[i], missing)) {
      if (!entry.is_regular_file()) continue;
      const std::vector<std::uint8_t> input = texmap::test::bytes_of(entry.path().string());
      std::fprintf(stderr, "%s\n", entry.path().string().c_str());
      LLVMFuzzerTestOneInput(input.data(), input.size());
      ++runs;
    }
  }
  std::fprintf(stderr, "%d files\n", runs);
  return runs > 0 ? 0 : 1;
}
