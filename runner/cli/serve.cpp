#include <malloc.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "runner/cli/commands.hpp"
#include "runner/daemon/local_executor.hpp"
#include "runner/daemon/loop.hpp"
#include "runner/doctor/database_checks.hpp"
#include "runner/slurm/slurm_executor.hpp"
#include "runner/slurm/time_limit.hpp"
#include "runner/web/bearer_token.hpp"
#include "runner/web/http_server.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

/// Makes malloc keep freed memory for the next request. Returning it to the system after each request took a
/// third of the daemon's time; the server returns it at most four times a second instead (trim_memory).
void keep_freed_memory() {
  constexpr int kKept = 1'000'000;  // bytes; the limit of each arena
  mallopt(M_TRIM_THRESHOLD, kKept);
  mallopt(M_MMAP_THRESHOLD, kKept);
  mallopt(M_ARENA_MAX, 4);  // otherwise each of sixteen threads could have its own
}

void warn_of_too_many_cores(int cores) {
  if (const int usable = usable_cores(); cores > usable)
    std::clog << "capstan: --cores " << cores << " is more than the " << usable
              << " that this process may use: cases will wait for each other" << std::endl;
}

void warn_of_unused_options(const ServeArguments& arguments) {
  if (!arguments.partition.empty() || !arguments.account.empty() || !arguments.time.empty() ||
      !arguments.extra.empty())
    std::clog
        << "capstan: --partition, --account, --time and --extra are for Slurm; without --executor slurm "
           "the cases are computed on this machine"
        << std::endl;
}

/// Files that the daemon and its runs create are readable by this user alone.
void keep_files_private() { umask(077); }

/// Ends the process in one second at the latest. Requests that take longer get no answer, as if the daemon
/// had been killed.
void exit_within_a_second(int code) {
  static constexpr std::chrono::seconds kMax{1};
  std::thread([code] {
    std::this_thread::sleep_for(kMax);
    std::_Exit(code);
  }).detach();
}

bool uses_slurm(const ServeArguments& arguments) { return arguments.executor == "slurm"; }

/// The program's own file, as jobs on other machines cannot start /proc/self/exe.
SlurmSettings slurm_settings(const ServeArguments& arguments) {
  if (arguments.wall_seconds > 0)
    throw std::invalid_argument("--wall-time is for local cases; with --executor slurm use --time");
  SlurmSettings settings{.program = std::filesystem::canonical("/proc/self/exe"),
                         .jobs = static_cast<std::size_t>(arguments.jobs),
                         .partition = arguments.partition,
                         .account = arguments.account,
                         .memory_mb = arguments.memory_mb};
  if (!arguments.time.empty()) {
    const auto time = parse_time_limit(arguments.time);
    if (!time) throw std::invalid_argument("--time: \"" + arguments.time + "\" is no time of Slurm");
    settings.max_time = *time;
  }
  std::istringstream words(arguments.extra);
  for (std::string word; words >> word;) settings.extra.push_back(word);
  return settings;
}

std::unique_ptr<Executor> executor_of(const ServeArguments& arguments, const DataDirectory& data,
                                      const Clock& clock) {
  if (!uses_slurm(arguments)) return std::make_unique<LocalExecutor>(arguments.cores);
  return std::make_unique<SlurmExecutor>(slurm_settings(arguments), data.runs(), clock);
}

/// Slurm enforces the limits of its jobs itself.
RunLimits limits_of(const ServeArguments& arguments) {
  if (uses_slurm(arguments)) return {};
  return {arguments.memory_mb, std::chrono::seconds(arguments.wall_seconds)};
}

}  // namespace

int serve(const ServeArguments& arguments) {
  ListenAddress address = parse_listen_address(arguments.listen);
  const AccessControl access{arguments.hosts, token_of_environment()};
  if (!is_loopback(address) && !access.token)
    throw std::invalid_argument("refusing to listen on " + address.host +
                                ", where other machines can reach it, without a token: set CAPSTAN_TOKEN or "
                                "CAPSTAN_TOKEN_FILE");
  hold_signals();
  keep_files_private();
  if (!uses_slurm(arguments)) {
    warn_of_too_many_cores(arguments.cores);
    warn_of_unused_options(arguments);
  }
  keep_freed_memory();
  const SystemClock clock;
  const DataDirectory data(arguments.data);
  const std::unique_ptr<Executor> executor = executor_of(arguments, data, clock);
  std::optional<Service> service;
  HttpServer server(data.path(), access);
  address = server.listen_at(address);
  {
    const EndAtOnce ends_at_once;
    refuse_damaged_database(data.database());
    service.emplace(data, *executor, clock, limits_of(arguments),
                    std::chrono::seconds(arguments.lease_seconds));
  }
  service->on_change(wake_loop);
  server.set_service(*service);
  std::cout << "Capstan serves " << url_of(address) << " with " << executor->slots() << " "
            << executor->slot_name() << ", data in " << data.path().string() << std::endl;
  if (!std::cout) return kExitError;  // a script that waits for this line would wait for ever
  const bool is_recorded = work_until_terminated(
      *service, [&] { server.reopen_log(); }, [&] { server.trim_memory(); });
  const int code = is_recorded ? kExitDone : kExitError;
  exit_within_a_second(code);
  return code;
}

}  // namespace capstan
