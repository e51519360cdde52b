#pragma once
// Connections for reading that stay open: to open one takes longer than most questions.
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

class Readers {
 public:
  /// \param writer  while its files are not in place, none is opened
  Readers(std::filesystem::path database, const Database& writer)
      : file_(std::move(database)), writer_(writer) {}

  struct GiveBack {
    Readers* readers;
    void operator()(Database* database) const { readers->give_back(database); }
  };
  /// Sees one moment, that of its first query, as long as it is held.
  using Reader = std::unique_ptr<Database, GiveBack>;

  /// More at once are opened and closed again: each that is kept has two descriptors, and who is quick needs
  /// few.
  static constexpr std::size_t kKept = 2;

  /// From any thread; as many as are asked for.
  Reader take();

 private:
  void give_back(Database* database);

  const std::filesystem::path file_;
  const Database& writer_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Database>> idle_;
};

}  // namespace capstan
