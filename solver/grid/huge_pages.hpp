#pragma once
// Memory for large arrays that are read from beginning to end: aligned to cache lines, and on pages of 2 MB
// where Linux provides them. With pages of 4 kB a sweep over 19 arrays would wait for address translation
// (TLB misses).
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace capstan {

inline constexpr std::size_t kCacheLine = 64;  ///< bytes

/// Numbers of type T in a cache line.
template <class T>
inline constexpr int kNumbersPerLine = kCacheLine / sizeof(T);

/// `numbers` rounded up to whole cache lines.
template <class T>
constexpr int whole_lines(int numbers) {
  return (numbers + kNumbersPerLine<T> - 1) / kNumbersPerLine<T> * kNumbersPerLine<T>;
}

template <class T>
struct HugePageAllocator {
  using value_type = T;
  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    constexpr std::size_t kHugePage = std::size_t(2) << 20;
    const std::size_t alignment = count * sizeof(T) >= kHugePage ? kHugePage : kCacheLine;
    const std::size_t bytes = (count * sizeof(T) + alignment - 1) / alignment * alignment;
    void* memory = std::aligned_alloc(alignment, bytes);
    if (!memory) throw std::bad_alloc();
    if (alignment == kHugePage)
      madvise(memory, bytes, MADV_HUGEPAGE);  // advice: if refused, small pages are used
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  bool operator==(const HugePageAllocator&) const = default;
};

}  // namespace capstan
