// doctest's main program, compiled once for all suites. It stops after ten failures.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest.h>

namespace {

constexpr int most_failures = 10;  // more of them say no more

/// doctest's own words, and at the end that the suite stopped.
struct Report : doctest::ConsoleReporter {
  using ConsoleReporter::ConsoleReporter;
  void test_run_end(const doctest::TestRunStats& stats) override {
    ConsoleReporter::test_run_end(stats);
    if (opt.abort_after > 0 && stats.numAssertsFailed >= opt.abort_after)
      s << "Stopped after " << opt.abort_after << " failures; --abort-after=1000 shows more.\n";
  }
};
REGISTER_REPORTER("course", 0, Report);

}  // namespace

int main(int argc, char** argv) {
  doctest::Context context;
  context.setOption("abort-after", most_failures);
  context.setOption("reporters", "course");
  context.applyCommandLine(argc, argv);
  return context.run();
}
