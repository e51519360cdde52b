// Speed of the queue, measured through the real daemon on the disk of $TMPDIR (or /tmp), with its targets:
//
//   cmake --preset test && cmake --build --preset test --target queue_benchmark &&
//   build/test/tests/queue_benchmark
//
// The cases run the fake solver (tests/support/fake_solver.cpp): V = 46 writes a record every 10 ms, V = 70
// waits.
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>
#include <vector>

#include "runner/daemon/process_identity.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Processor time of the daemon so far.
double cpu_milliseconds(const Daemon& daemon) {
  return 1000 * usage_of(identify(daemon.pid()).value()).value().cpu_seconds;
}

nlohmann::json range(double from, double to, int count) {
  return {{"from", from}, {"to", to}, {"count", count}};
}

std::string submit(Client& client, const std::string& name, const nlohmann::json& axes) {
  return client.post("/v1/studies", study_document(name, axes).dump())["id"];
}

void measure_submissions() {
  constexpr int kClients = 8, kEach = 250;
  const TemporaryDirectory data;
  const Daemon daemon(data.path(), {"--cores", "1"});
  const auto start = Clock::now();
  std::vector<std::thread> clients;
  for (int c = 0; c < kClients; ++c)
    clients.emplace_back([&daemon, c] {
      Client client(daemon.url());
      for (int i = 0; i < kEach; ++i) {
        const double Ca = 0.01 * (1 + c) + 0.00001 * i;
        submit(client, "s", {{"Ca", range(Ca, Ca + 1, 10)}, {"V", {70}}});
      }
    });
  for (std::thread& client : clients) client.join();
  const double time = milliseconds_since(start);
  std::printf(
      "submissions   %6.0f /s   studies of 10 cases, %d clients, %.2f ms of the daemon's CPU each; target: "
      "500 /s or more\n",
      1000 * kClients * kEach / time, kClients, cpu_milliseconds(daemon) / (kClients * kEach));
}

void measure_status() {
  constexpr int kQueries = 2000;
  const TemporaryDirectory data;
  const Daemon daemon(data.path(), {"--cores", "8"});
  Client client(daemon.url());
  const std::string id = submit(client, "status", {{"Ca", range(0.1, 1, 10000)}, {"V", {46}}});
  wait_for_cases(client, id, "running", 8);
  std::vector<double> times;
  const double cpu_before = cpu_milliseconds(daemon);
  for (int i = 0; i < kQueries; ++i) {
    const auto start = Clock::now();
    client.get("/v1/studies/" + id);
    times.push_back(milliseconds_since(start));
  }
  std::sort(times.begin(), times.end());
  std::printf(
      "status        %6.2f ms   p99; p50 %.2f ms, %.2f ms of the daemon's CPU each, 10,000 queued, 8 write; "
      "target: 20 ms or less\n",
      times[kQueries * 99 / 100], times[kQueries / 2], (cpu_milliseconds(daemon) - cpu_before) / kQueries);
}

double peak_memory_mb(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1000;
  return 0;
}

void measure_memory() {
  const TemporaryDirectory data;
  const Daemon daemon(data.path(), {"--cores", "1"});
  Client client(daemon.url());
  for (int i = 0; i < 10; ++i) submit(client, "m", {{"Ca", range(0.1 + i, 1 + i, 10000)}, {"V", {70}}});
  for (const auto& study : client.get_all("/v1/studies", "studies"))
    client.get("/v1/studies/" + study["id"].get<std::string>());
  std::printf("memory        %6.0f MB   peak of the daemon with 100,000 cases; target: 100 MB or less\n",
              peak_memory_mb(daemon.pid()));
}

/// Mean time of a process of a case without the daemon, in milliseconds.
double process_time(int count, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  std::ofstream(directory / "case.json") << R"({"V": 4, "Ca": 0.25, "until": {"kt": 30}})";
  std::string words[] = {"capstan", "solve", directory / "case.json", "--out", directory};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), nullptr};
  const auto start = Clock::now();
  for (int i = 0; i < count; ++i) {
    pid_t pid = 0;
    posix_spawn(&pid, CAPSTAN_PROGRAM, nullptr, nullptr, arguments, environ);
    waitpid(pid, nullptr, 0);
  }
  return milliseconds_since(start) / count;
}

void measure_overhead() {
  constexpr int kCases = 500;
  const TemporaryDirectory data;
  Daemon daemon(data.path(), {"--cores", "1"});
  Client client(daemon.url());
  const std::string id = submit(client, "overhead", {{"Ca", range(0.1, 1, kCases)}, {"V", {4}}});
  const int before = client.get("/v1/studies/" + id)["cases"]["done"];
  const auto start = Clock::now();
  wait_for_cases(client, id, "done", kCases);
  const double cycle = milliseconds_since(start) / (kCases - before);
  const double process = process_time(100, data.path() / "alone");
  std::printf("overhead      %6.1f ms   a case of %.1f ms, its process takes %.1f; target: 20 ms or less\n",
              cycle - process, cycle, process);
}

}  // namespace
}  // namespace capstan

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  capstan::measure_submissions();
  capstan::measure_status();
  capstan::measure_memory();
  capstan::measure_overhead();
}
