#include "solver/run_directory/durable_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "solver/run_directory/attempt_token.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const char* operation, const fs::path& path) {
  const std::error_code reason(errno, std::generic_category());
  throw fs::filesystem_error(operation, path, reason);
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : path_(path), fd_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {
    if (fd_ < 0) fail("cannot open", path_);
  }
  ~Descriptor() { ::close(fd_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail("cannot write", path_);
      bytes.remove_prefix(static_cast<size_t>(written));
    }
  }

  std::string read() {
    std::string bytes;
    char part[1 << 16];
    for (;;) {
      const ssize_t count = ::read(fd_, part, sizeof part);
      if (count == 0) return bytes;
      if (count < 0 && errno != EINTR) fail("cannot read", path_);
      if (count > 0) bytes.append(part, static_cast<size_t>(count));
    }
  }

  void sync() {
    while (::fsync(fd_) != 0)
      if (errno != EINTR) fail("cannot sync", path_);
  }

 private:
  const fs::path& path_;
  int fd_;
};

fs::path directory_of(const fs::path& path) {
  const fs::path parent = path.parent_path();
  return parent.empty() ? fs::path(".") : parent;
}

}  // namespace

PendingFile::PendingFile(fs::path target) : target_(std::move(target)), temporary_(temporary_name(target_)) {}

PendingFile::~PendingFile() {
  std::error_code ignored;  // there is no such file after publish()
  fs::remove(temporary_, ignored);
}

void PendingFile::replace() {
  expect_own_attempt();
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot rename to", target_);
}

void PendingFile::publish() {
  Descriptor(temporary_, O_RDONLY).sync();
  replace();
  const fs::path directory = directory_of(target_);
  Descriptor(directory, O_RDONLY | O_DIRECTORY).sync();
}

std::optional<std::string> read_file(const fs::path& path) try {
  return Descriptor(path, O_RDONLY).read();
} catch (const fs::filesystem_error& error) {
  if (error.code() == std::errc::no_such_file_or_directory || error.code() == std::errc::not_a_directory)
    return std::nullopt;
  throw;
}

bool is_shortage(const fs::filesystem_error& error) {
  for (const std::errc shortage : {std::errc::too_many_files_open, std::errc::too_many_files_open_in_system,
                                   std::errc::not_enough_memory})
    if (error.code() == shortage) return true;
  return false;
}

void write_durably(const fs::path& path, std::string_view bytes) {
  PendingFile file(path);
  {
    Descriptor out(file.temporary(), O_WRONLY | O_CREAT | O_TRUNC);
    out.write(bytes);
    out.sync();  // a network file system reports a full disk only to the descriptor that wrote
  }
  file.publish();
}

void write_atomically(const fs::path& path, std::string_view bytes) {
  PendingFile file(path);
  Descriptor(file.temporary(), O_WRONLY | O_CREAT | O_TRUNC).write(bytes);
  file.replace();
}

void link_file(const fs::path& from, const fs::path& to) {
  if (fs::exists(to)) return;
  std::error_code no_links;
  fs::create_hard_link(from, to, no_links);
  if (no_links) fs::copy_file(from, to);
}

void link_files(const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.is_regular_file()) link_file(entry.path(), to / entry.path().filename());
}

}  // namespace capstan
