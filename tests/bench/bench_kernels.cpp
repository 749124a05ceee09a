// bench_kernels: the small works of bench_ratios in Google Benchmark, with its options and its
// statistics.
#include <benchmark/benchmark.h>

#include <string>

#include "bench.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const texmap::bench::Group& group : texmap::bench::all_groups()) {
    if (!group.micro) continue;
    for (const texmap::bench::Row& row : group.rows) {
      if (!row.prepare) continue;
      // Prepared when its turn comes; --benchmark_filter may choose a few of many.
      benchmark::RegisterBenchmark(
          (group.name + "/" + row.line + "/" + row.column).c_str(), [row](benchmark::State& state) {
            const texmap::Work work = row.prepare();
            for (auto _ : state) work();
            state.SetItemsProcessed(
                static_cast<std::int64_t>(static_cast<double>(state.iterations()) * row.items));
          });
    }
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
