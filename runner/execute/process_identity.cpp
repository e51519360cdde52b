#include "runner/execute/process_identity.hpp"

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <charconv>
#include <fstream>
#include <sstream>

namespace capstan {
namespace {

std::string boot_id() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id;
}

}  // namespace

std::optional<ProcessIdentity> identify(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  std::istringstream fields(
      line.substr(line.rfind(')') + 1));  // the name in front may hold spaces and brackets
  std::string field, state;
  fields >> state;
  for (int number = 4; number <= 22; ++number) fields >> field;
  if (state == "Z" || state == "X") return std::nullopt;
  return ProcessIdentity{pid, field, boot_id()};
}

std::string to_text(const ProcessIdentity& process) {
  return std::to_string(process.pid) + ":" + process.start_time + ":" + process.boot_id;
}

std::optional<ProcessIdentity> process_from_text(const std::string& text) {
  ProcessIdentity process;
  const std::size_t first = text.find(':');
  const std::size_t second = text.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return std::nullopt;
  const auto read = std::from_chars(text.data(), text.data() + first, process.pid);
  if (read.ec != std::errc() || process.pid <= 1) return std::nullopt;
  process.start_time = text.substr(first + 1, second - first - 1);
  process.boot_id = text.substr(second + 1);
  return process;
}

bool is_alive(const ProcessIdentity& process) { return identify(process.pid) == process; }

bool wait_for_end(const ProcessIdentity& process, int milliseconds) {
  const int descriptor = static_cast<int>(syscall(SYS_pidfd_open, process.pid, 0));
  if (descriptor < 0 || !is_alive(process)) {
    if (descriptor >= 0) close(descriptor);
    return !is_alive(process);
  }
  pollfd ended{descriptor, POLLIN, 0};
  poll(&ended, 1, milliseconds);
  close(descriptor);
  return !is_alive(process);
}

}  // namespace capstan
