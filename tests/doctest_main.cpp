// doctest's main program, compiled once for all suites.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest.h>

#include <cstdio>

int main(int argc, char** argv) {
  constexpr int most_failures = 10;  // more of them say no more
  doctest::Context context;
  context.setOption("abort-after", most_failures);
  context.applyCommandLine(argc, argv);
  const int status = context.run();
  if (status != 0 && !context.shouldExit())
    std::fprintf(stderr, "At most %d failures are shown; %s --abort-after=0 shows all.\n",
                 most_failures, argv[0]);
  return status;
}
