#include "runner/daemon/process_identity.hpp"

#include <poll.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace capstan {
namespace {

std::string boot_id() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id;
}

/// The fields of /proc/PID/stat (proc(5)) from the third on: field N is at N - 3. Empty if the process has
/// ended.
std::vector<std::string> stat_fields(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  if (!std::getline(file, line)) return {};
  const std::size_t end_of_name = line.rfind(')');  // field 2, which may contain spaces and brackets
  std::istringstream stream(line.substr(end_of_name + 1));
  std::vector<std::string> fields{std::istream_iterator<std::string>(stream), {}};
  const bool has_ended = fields.size() < 22 || fields[0] == "Z" || fields[0] == "X";
  return has_ended ? std::vector<std::string>() : fields;
}

}  // namespace

std::optional<ProcessIdentity> identify(pid_t pid) {
  const std::vector<std::string> fields = stat_fields(pid);
  if (fields.empty()) return std::nullopt;
  return ProcessIdentity{pid, fields[22 - 3], boot_id()};
}

std::optional<ProcessUsage> usage_of(const ProcessIdentity& process) {
  const std::vector<std::string> fields = stat_fields(process.pid);
  if (fields.empty() || fields[22 - 3] != process.start_time) return std::nullopt;
  const double ticks = std::stod(fields[14 - 3]) + std::stod(fields[15 - 3]);
  const double pages = std::stod(fields[24 - 3]);
  return ProcessUsage{ticks / static_cast<double>(sysconf(_SC_CLK_TCK)),
                      pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6};
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
