#include "runner/web/http_metrics.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "runner/queries/metrics.hpp"

namespace capstan {
namespace {

template <class Number>
std::string gauge(const std::string& name, const std::string& help, Number value) {
  return metric_description(name, "gauge", help) + name + " " + std::to_string(value) + "\n";
}

long resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  long all = 0, resident = 0;
  pages >> all >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

long open_files() {
  const std::filesystem::directory_iterator files("/proc/self/fd");
  return std::distance(begin(files), end(files));
}

}  // namespace

void HttpMetrics::count_request(int status, std::chrono::duration<double> time) {
  const std::lock_guard lock(mutex_);
  ++requests_[status];
  seconds_ += time.count();
}

std::string HttpMetrics::text() {
  const std::string requests = "capstan_http_requests_total", seconds = "capstan_http_request_seconds_total";
  std::ostringstream text;
  text << metric_description(requests, "counter", "Requests by the status of their answer.");
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [status, count] : requests_)
      text << requests << "{code=\"" << status << "\"} " << count << '\n';
    text << metric_description(seconds, "counter",
                               "Time from accepting a connection to the end of its answer.")
         << seconds << ' ' << seconds_ << '\n';
  }
  text << gauge("capstan_http_connections", "Connections that are being served.", connections.load())
       << gauge("capstan_http_streams", "Clients that follow a study.", streams.load())
       << gauge("process_resident_memory_bytes", "Memory of the server, without its runs.", resident_bytes())
       << gauge("process_open_fds", "Open files of the server.", open_files());
  return text.str();
}

HttpMetrics& http_metrics() {
  static HttpMetrics of_this_process;
  return of_this_process;
}

}  // namespace capstan
