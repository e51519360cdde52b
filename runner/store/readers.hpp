#pragma once
// A pool of connections for reading: opening one takes longer than most queries.
#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// May be used from any thread.
class Readers {
 public:
  /// \param writer  no connection is opened while its files are missing or replaced
  Readers(std::filesystem::path database, const Database& writer)
      : file_(std::move(database)), writer_(writer) {}

  struct GiveBack {
    Readers* readers;
    void operator()(Database* database) const { readers->give_back(database); }
  };
  /// A read transaction: a consistent snapshot, taken at the first query. For one thread at a time.
  using Reader = std::unique_ptr<Database, GiveBack>;

  /// Max number of unused connections that stay open. Each has two descriptors; queries are short, so few
  /// connections serve many clients.
  static constexpr std::size_t kMaxIdle = 2;

  /// Never waits for another reader: if none is idle, a connection is opened.
  Reader take();

 private:
  void give_back(Database* database);

  const std::filesystem::path file_;
  const Database& writer_;
  std::mutex mutex_;  ///< guards idle_
  std::vector<std::unique_ptr<Database>> idle_;
};

}  // namespace capstan
