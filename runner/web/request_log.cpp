#include "runner/web/request_log.hpp"

#include <algorithm>

namespace capstan {

RequestLog::RequestLog(std::filesystem::path file, std::size_t max_bytes)
    : file_(std::move(file)), max_bytes_(max_bytes), stream_(file_, std::ios::app) {}

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
  if (static_cast<std::size_t>(std::max<std::streamoff>(0, stream_.tellp())) < max_bytes_) return;
  std::error_code ignored;  // requests are answered even if the log cannot be renamed
  std::filesystem::rename(file_, file_.string() + ".1", ignored);
  stream_ = std::ofstream(file_, std::ios::app);
}

}  // namespace capstan
