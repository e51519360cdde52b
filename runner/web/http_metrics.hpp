#pragma once
// Counters and gauges of the HTTP server, for GET /metrics.
#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace capstan {

class HttpMetrics {
 public:
  /// \param time  from accepting the connection to the end of its response
  void count_request(int status, std::chrono::duration<double> time);

  std::atomic<int> connections = 0;  ///< that a request thread is serving
  std::atomic<int> streams = 0;      ///< of those, the ones that carry a stream of events

  /// In Prometheus' text format, with the memory and the open files of the process.
  std::string text();

 private:
  std::mutex mutex_;
  std::map<int, std::uint64_t> requests_;  ///< by status
  double seconds_ = 0;
};

/// The metrics of this process since its start.
HttpMetrics& http_metrics();

}  // namespace capstan
