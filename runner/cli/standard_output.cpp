#include "runner/cli/standard_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

namespace capstan {
namespace {

/// Whether the other end of a pipe or connection is closed.
bool reader_is_gone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

}  // namespace

void occupy_closed_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    open(
        "/dev/null",
        stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // open() returns the lowest free descriptor: `stream`
  }
}

bool flush_standard_output() {
  errno = 0;
  std::cout.flush();
  const bool is_flushed = std::fflush(stdout) == 0;
  const int reason = errno;
  if (is_flushed && std::cout.good() && std::ferror(stdout) == 0) return true;
  if (reason != EPIPE && !reader_is_gone())
    std::cerr << "capstan: cannot write to standard output"
              << (reason != 0 ? std::string(": ") + std::strerror(reason) : "") << '\n';
  return false;
}

}  // namespace capstan
