#include "runner/store/orphaned_runs.hpp"

namespace capstan {
namespace {

constexpr std::size_t kIdLength = 16;

bool has_form_of_an_id(const std::string& name) {
  return name.size() == kIdLength && name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

std::vector<RunDirectory> orphaned_runs(const std::filesystem::path& runs, Database& database) {
  std::vector<RunDirectory> orphans;
  if (!std::filesystem::exists(runs)) return orphans;
  for (const auto& entry : std::filesystem::directory_iterator(runs)) {
    const std::string name = entry.path().filename();
    if (has_form_of_an_id(name) && !database.query("SELECT 1 FROM cases WHERE id = ?", name).step())
      orphans.emplace_back(entry.path());
  }
  return orphans;
}

}  // namespace capstan
