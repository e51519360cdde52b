#include <iostream>
#include <memory>
#include <thread>

#include "runner/cli/commands.hpp"
#include "runner/execute/exit_code.hpp"
#include "runner/execute/local_executor.hpp"
#include "runner/service/loop.hpp"
#include "runner/web/server.hpp"

namespace capstan {
namespace {

struct ServeArguments {
  std::string data = "capstan-data";
  std::string listen = "127.0.0.1:8017";
  int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};

int serve(const ServeArguments& arguments) {
  const Address address = parse_loopback_address(arguments.listen);
  hold_signals();
  const SystemClock clock;
  const DataDirectory data(arguments.data);
  LocalExecutor executor;
  Service service(data, executor, clock, arguments.cores);
  service.on_change(wake_loop);
  const Server server(service, address);
  std::cout << "Capstan serves " << url_of(server.address()) << " with " << arguments.cores
            << (arguments.cores == 1 ? " core" : " cores") << ", data in " << data.path().string()
            << std::endl;
  work_until_terminated(service);
  return kExitDone;
}

}  // namespace

Action declare_serve(CLI::App& command) {
  auto arguments = std::make_shared<ServeArguments>();
  command.add_option("--data", arguments->data, "where everything is kept; made if it is not there")
      ->type_name("DIR")
      ->capture_default_str();
  command.add_option("--listen", arguments->listen, "port 0 takes any free port")
      ->type_name("HOST:PORT")
      ->capture_default_str();
  command.add_option("--cores", arguments->cores, "cases that run side by side")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command.footer(
      "Ctrl-C or SIGTERM: running cases write a checkpoint, and the next start goes on from there.\n"
      "Example:\n  capstan serve --data /srv/capsules --cores 4\n");
  return [arguments] { return serve(*arguments); };
}

}  // namespace capstan
