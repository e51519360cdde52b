// How the costs of the daemon grow with the number of cases. The cases are not computed: each run directory
// gets a result at once. Real database and real files in $TMPDIR (or /tmp).
//
//   cmake --preset test && cmake --build --preset test --target scale_benchmark &&
//   build/test/tests/scale_benchmark 1000 10000 100000
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "runner/daemon/service.hpp"
#include "runner/queries/metrics.hpp"
#include "runner/queries/queries.hpp"
#include "runner/slurm/listed_task.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using Stopwatch = std::chrono::steady_clock;

double milliseconds_since(Stopwatch::time_point start) {
  return std::chrono::duration<double, std::milli>(Stopwatch::now() - start).count();
}

/// Runs that have a result when they are started. While `is_holding` they go on without one.
class NoOpExecutor : public Executor {
 public:
  std::size_t slots() const override { return kRoom; }
  std::string slot_name() const override { return "slots"; }
  bool has_room(std::size_t runs, std::size_t /*waiting*/) override { return runs < kRoom; }
  RunHandle start(const Claim& claim, const RunDirectory& directory) override {
    if (!is_holding)
      write_atomically(directory.result_file(), R"({"stop": "reached_end", "motion": "tumbling"})");
    return claim.token;
  }
  std::optional<ProcessEnd> poll(const RunHandle& /*run*/) override {
    if (is_holding) return std::nullopt;
    return ProcessEnd{ProcessEnd::How::exited, 75};
  }
  std::optional<RunUsage> usage(const RunHandle& /*run*/) override { return std::nullopt; }
  void cancel(const RunHandle& /*run*/, StopBy /*stop*/) override {}
  bool wait_until_free(const RunDirectory& /*directory*/) override { return true; }
  RunPlace place(const RunHandle& /*run*/) const override { return {false, "running", "nowhere"}; }

  static constexpr std::size_t kRoom = 1000;
  bool is_holding = true;
};

void submit(Service& service, int cases) {
  for (int first = 0; first < cases; first += kMaxCases) {
    const int count = std::min(cases - first, static_cast<int>(kMaxCases));
    const double V = 1 + 1e-5 * first;
    service.submit(sample_study("scale", {{"Ca", {{"from", 0.1}, {"to", 1}, {"count", count}}}, {"V", {V}}}));
  }
}

std::size_t waiting_cases(Service& service) {
  const Readers::Reader reader = service.reader();
  Statement row = reader->query("SELECT count FROM totals WHERE what = 'cases' AND name = 'queued'");
  return row.step() ? static_cast<std::size_t>(row.integer(0)) : 0;
}

double megabytes_in(const std::filesystem::path& directory) {
  double bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.is_regular_file()) bytes += static_cast<double>(entry.file_size());
  return bytes / 1e6;
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1000;
}

double time_of(const std::function<void()>& action) {
  const auto start = Stopwatch::now();
  action();
  return milliseconds_since(start);
}

void measure(int cases) {
  const TemporaryDirectory directory;
  const DataDirectory data(directory.path());
  const SystemClock clock;
  NoOpExecutor executor;
  Service service(data, executor, clock);
  const double submission = time_of([&] { submit(service, cases); });
  for (int i = 0; i < 2; ++i) service.tick();  // each starts 500
  const double idle_tick = time_of([&] { service.tick(); });
  executor.is_holding = false;
  const double all_ticks = time_of([&] {
    while (waiting_cases(service) > 0 || !service.is_idle()) service.tick();
  });
  const double metrics = time_of([&] { metrics_text(*service.reader(), 1); });
  const double page = time_of([&] { list_studies(*service.reader(), {}); });
  std::printf("%8d  %10.3f  %9.3f  %12.1f  %10.2f  %8.2f  %9.1f  %6.0f\n", cases, submission / cases,
              all_ticks / cases, idle_tick, metrics, page, 1000 * megabytes_in(data.path()) / cases,
              peak_memory_mb());
}

void measure_squeue(int tasks) {
  std::string text;
  for (int i = 0; i < tasks; ++i)
    text += "17_" + std::to_string(i) + "|" + std::to_string(i) +
            "|PENDING|Priority||capstan-0123456789abcdef-1-1234567890-1234567890-1234567890-1234567890\n";
  const double time = time_of([&] { parse_squeue(text); });
  std::printf("squeue of %d tasks: %.1f MB, read in %.1f ms\n", tasks, static_cast<double>(text.size()) / 1e6,
              time);
}

}  // namespace
}  // namespace capstan

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  std::puts(
      "   cases  submit, ms  run, ms  tick/1000, ms  metrics, ms  list, ms  disk, kB  memory, MB\n"
      "          a case      a case    1000 running                          a case   peak");
  for (int i = 1; i < argc; ++i) capstan::measure(std::atoi(argv[i]));
  for (const int tasks : {1000, 10000, 100000}) capstan::measure_squeue(tasks);
}
