#include "runner/daemon/remove_deleted_cases.hpp"

#include "runner/daemon/delete_study.hpp"

namespace capstan {

void remove_deleted_cases(Database& database, const DataDirectory& data) {
  constexpr int kMaxAtOnce = 50;  // clients wait for the writer's mutex meanwhile
  std::vector<std::string> removed;
  for (const std::string& id : delete_unwanted_cases(database, kMaxAtOnce)) {
    std::error_code error;
    std::filesystem::remove_all(data.run(id).path(), error);
    if (!error) removed.push_back(id);
  }
  forget_deleted(database, removed);
}

}  // namespace capstan
