// Fuzz target: the server gets any bytes on a connection. It must close the connection or answer, never with
// 500.
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "runner/web/http_server.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_executor.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

using namespace capstan;

namespace {

struct Server {
  TemporaryDirectory directory;
  DataDirectory data{directory.path()};
  FakeExecutor executor;
  FakeClock clock;
  Service service{data, executor, clock};
  HttpServer http{data.path(), AccessControl{{"named.example"}, {}}};
  Server() {
    http.set_service(service);
    service.submit(sample_study("kept", {{"Ca", {0.25, 0.75}}}));
  }
};

std::string receive_all(int socket) {
  std::string all;
  char part[4096];
  for (ssize_t count; (count = recv(socket, part, sizeof part, 0)) > 0;)
    all.append(part, static_cast<std::size_t>(count));
  return all;
}

bool is_allowed(const std::string& answer) {
  return answer.empty() || (answer.starts_with("HTTP/1.1 ") && !answer.starts_with("HTTP/1.1 500"));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Server server;
  constexpr std::size_t kMax = 64 << 10;  // what a socket buffers before anyone reads
  int ends[2];
  if (size > kMax || socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0) return 0;
  if (send(ends[0], data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  shutdown(ends[0], SHUT_WR);
  server.http.adopt(ends[1]);
  const std::string answer = receive_all(ends[0]);
  close(ends[0]);
  if (!is_allowed(answer)) std::abort();
  return 0;
}
