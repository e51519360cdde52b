#pragma once
// Whether the disk has room for more runs.
#include <cstdint>
#include <filesystem>
#include <string>

#include "runner/store/data_directory.hpp"

namespace capstan {

class FreeSpace {
 public:
  /// \param runs  the directory of the run directories
  explicit FreeSpace(std::filesystem::path runs) : runs_(std::move(runs)) {}

  void set_min_free(std::uintmax_t bytes) { min_free_ = bytes; }

  /// Why no run is started, as a sentence for users; "" if there is room.
  std::string shortage() const;

 private:
  const std::filesystem::path runs_;
  std::uintmax_t min_free_ = kMinFree;  ///< bytes
};

}  // namespace capstan
