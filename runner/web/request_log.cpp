#include "runner/web/request_log.hpp"

#include <algorithm>

namespace capstan {

RequestLog::RequestLog(std::filesystem::path file, std::size_t most)
    : file_(std::move(file)), most_(most), stream_(file_, std::ios::app) {}

void RequestLog::reopen() {
  const std::lock_guard lock(mutex_);
  stream_ = std::ofstream(file_, std::ios::app);
}

void RequestLog::write(const std::string& line) {
  std::string shown = line;
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  const std::lock_guard lock(mutex_);
  stream_ << shown << std::endl;
  if (static_cast<std::size_t>(std::max<std::streamoff>(0, stream_.tellp())) < most_) return;
  std::error_code ignored;  // a log that cannot be kept is no reason to answer nobody
  std::filesystem::rename(file_, file_.string() + ".1", ignored);
  stream_ = std::ofstream(file_, std::ios::app);
}

}  // namespace capstan
