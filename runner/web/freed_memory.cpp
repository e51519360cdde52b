#include "runner/web/freed_memory.hpp"

#include <malloc.h>

namespace capstan {

void FreedMemory::after_response(std::size_t bytes) {
  constexpr std::size_t kLarge = 256 << 10;
  has_answered_ = true;
  if (bytes < kLarge) return;
  if (const std::unique_lock lock(trimming_, std::try_to_lock); lock) malloc_trim(0);
}

void FreedMemory::trim() {
  constexpr std::chrono::milliseconds kInterval{250};
  const auto now = std::chrono::steady_clock::now();
  if (now < last_trim_ + kInterval || !has_answered_.exchange(false)) return;
  malloc_trim(0);
  last_trim_ = now;
}

}  // namespace capstan
