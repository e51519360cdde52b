#include <malloc.h>

#include <iostream>
#include <stdexcept>

#include "runner/cli/commands.hpp"
#include "runner/execute/exit_code.hpp"
#include "runner/execute/local_executor.hpp"
#include "runner/service/loop.hpp"
#include "runner/web/server.hpp"

namespace capstan {
namespace {

/// What one request has freed serves the next: to give it back to the system each time takes a third of the
/// daemon's time.
void keep_freed_memory() {
  constexpr int kKept = 1'000'000;  // bytes a thread, at most
  mallopt(M_TRIM_THRESHOLD, kKept);
  mallopt(M_MMAP_THRESHOLD, kKept);
  mallopt(M_ARENA_MAX, 4);  // of sixteen threads each would keep as much
}

}  // namespace

int serve(const ServeArguments& arguments) {
  const Address address = parse_address(arguments.listen);
  const Access access{arguments.hosts, token_of_environment()};
  if (!is_loopback(address) && !access.token)
    throw std::invalid_argument("refusing to listen on " + address.host +
                                ", where other machines can reach it, without a token: set CAPSTAN_TOKEN or "
                                "CAPSTAN_TOKEN_FILE");
  hold_signals();
  keep_freed_memory();
  const SystemClock clock;
  const DataDirectory data(arguments.data);
  LocalExecutor executor;
  Service service(data, executor, clock, arguments.cores,
                  {arguments.memory_mb, std::chrono::seconds(arguments.wall_seconds)},
                  std::chrono::seconds(arguments.lease_seconds));
  service.on_change(wake_loop);
  const Server server(service, address, access);
  std::cout << "Capstan serves " << url_of(server.address()) << " with " << arguments.cores
            << (arguments.cores == 1 ? " core" : " cores") << ", data in " << data.path().string()
            << std::endl;
  return work_until_terminated(service) ? kExitDone : kExitError;
}

}  // namespace capstan
