// What every fuzz target is made of: libFuzzer's functions, and claims that must hold.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>

#include "engine/files/file_error.hpp"

/// Tries one input, of any bytes; whatever is wrong ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// A target may define this: changes an input in place, to at most `max_size` bytes.
/// Returns the new size.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed);
/// libFuzzer's own changes.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace texmap::test {

/// Ends the program, unless the claim holds.
inline void claim(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "this claim does not hold: %s\n", what);
  std::abort();
}

/// Loads a file of any bytes: what is refused is refused with a reason that a terminal can show.
template <class Load>
int loads_or_refuses(const Load& load) {
  try {
    load();
  } catch (const FileError& error) {
    const std::string_view why = error.what();
    claim(!why.empty() && why.size() < 200, "a refusal says why, in short");
    for (const char c : why) claim(c >= ' ' && c <= '~', "a terminal can show it");
  } catch (const std::bad_alloc&) {
    // It may be too large for this machine.
  }
  return 0;
}

}  // namespace texmap::test
