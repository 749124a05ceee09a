// doctest's main program, compiled once for all suites. It stops after ten failures.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest.h>

#include <cstdio>

namespace {

constexpr int most_failures = 10;  // more of them say no more

/// Says which tests were skipped and why, and at the end that the suite stopped.
struct Notices : doctest::IReporter {
  explicit Notices(const doctest::ContextOptions& /*options*/) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats& stats) override {
    const int most = doctest::getContextOptions()->abort_after;
    if (most <= 0 || stats.numAssertsFailed < most) return;
    std::printf("Stopped after %d failures; --abort-after=0 shows all.\n", most);
    std::fflush(stdout);
  }
  void test_case_start(const doctest::TestCaseData&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  /// Not of those that the command line leaves out.
  void test_case_skipped(const doctest::TestCaseData& test) override {
    if (!test.m_skip) return;
    const char* why = test.m_description != nullptr ? test.m_description : "";
    std::printf("Skipped: %s: %s\n", test.m_name, why);
  }
};
REGISTER_LISTENER("notices", 1, Notices);

}  // namespace

int main(int argc, char** argv) {
  doctest::Context context;
  context.setOption("abort-after", most_failures);
  context.applyCommandLine(argc, argv);
  return context.run();
}
