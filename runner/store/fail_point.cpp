#include "runner/store/fail_point.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string>

namespace capstan {
namespace {

struct FailAt {
  std::string name;
  std::atomic<int> passes_left = 0;

  FailAt() {
    const char* wanted = std::getenv("CAPSTAN_FAIL_AT");
    if (!wanted) return;
    name = wanted;
    const std::size_t colon = name.find(':');
    passes_left = colon == std::string::npos ? 1 : std::atoi(name.c_str() + colon + 1);
    name.resize(std::min(colon, name.size()));
  }
};

}  // namespace

void fail_point(std::string_view name) {
  static FailAt fail_at;
  if (name == fail_at.name && --fail_at.passes_left == 0) kill(getpid(), SIGKILL);
}

}  // namespace capstan
