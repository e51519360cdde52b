#include <malloc.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <thread>

#include "runner/cli/commands.hpp"
#include "runner/daemon/local_executor.hpp"
#include "runner/daemon/loop.hpp"
#include "runner/doctor/database_checks.hpp"
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
  warn_of_too_many_cores(arguments.cores);
  keep_freed_memory();
  const SystemClock clock;
  const DataDirectory data(arguments.data);
  LocalExecutor executor;
  std::optional<Service> service;
  HttpServer server(data.path(), access);
  address = server.listen_at(address);
  {
    const EndAtOnce ends_at_once;
    refuse_damaged_database(data.database());
    service.emplace(data, executor, clock, arguments.cores,
                    RunLimits{arguments.memory_mb, std::chrono::seconds(arguments.wall_seconds)},
                    std::chrono::seconds(arguments.lease_seconds));
  }
  service->on_change(wake_loop);
  server.set_service(*service);
  std::cout << "Capstan serves " << url_of(address) << " with " << arguments.cores
            << (arguments.cores == 1 ? " core" : " cores") << ", data in " << data.path().string()
            << std::endl;
  if (!std::cout) return kExitError;  // a script that waits for this line would wait for ever
  const bool is_recorded = work_until_terminated(
      *service, [&] { server.reopen_log(); }, [&] { server.trim_memory(); });
  const int code = is_recorded ? kExitDone : kExitError;
  exit_within_a_second(code);
  return code;
}

}  // namespace capstan
