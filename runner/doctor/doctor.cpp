#include "runner/doctor/doctor.hpp"

#include <functional>
#include <optional>

#include "runner/doctor/damaged_checkpoints.hpp"
#include "runner/doctor/database_checks.hpp"
#include "runner/doctor/run_checks.hpp"
#include "runner/store/data_directory.hpp"
#include "runner/store/database.hpp"
#include "runner/store/schema.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

class Doctor {
 public:
  Doctor(const fs::path& data, bool repairs)
      : data_(data),
        runs_(data / kRunsName),
        repairs_(repairs),
        database_(data / kDatabaseName, repairs ? Database::Access::write : Database::Access::read) {}

  std::vector<Finding> findings() && {
    check_disk();
    if (check_pages()) {
      check_sums();
      check_runs(runs_, database_, [this](const auto& what, const auto& repair) { report(what, repair); });
      check_checkpoints();
    }
    return std::move(findings_);
  }

 private:
  /// \param repair  empty if nothing can be done
  void report(const std::string& what, const std::function<void()>& repair = {}) {
    const bool is_repaired = repairs_ && repair;
    if (is_repaired) repair();
    findings_.push_back({what, is_repaired ? Finding::Kind::repaired : Finding::Kind::error});
  }

  void check_disk() {
    if (!fs::exists(runs_)) report(runs_.string() + " is missing", [this] { fs::create_directories(runs_); });
    for (const fs::path& place : {data_, runs_})
      if (fs::exists(place) && fs::space(place).available < kMinFree)
        report("less than " + std::to_string(kMinFree / 1'000'000) + " MB are free in " + place.string());
  }

  /// False if the database is damaged: then its rows are not checked. Rebuilding the indices repairs some
  /// damage.
  bool check_pages() {
    const std::vector<std::string> damage = damage_of(database_);
    if (damage.empty()) return true;
    if (repairs_) database_.execute_script("REINDEX");
    const bool is_repaired = repairs_ && damage_of(database_).empty();
    for (const std::string& what : damage)
      findings_.push_back(
          {"the database: " + what, is_repaired ? Finding::Kind::repaired : Finding::Kind::error});
    return is_repaired;
  }

  void check_sums() {
    for (const std::string& study : miscounted_studies(database_))
      report("the sums of study " + study + " are not those of its cases", [this] {
        Transaction transaction(database_);
        database_.execute_script(kRecount);
        transaction.commit();
      });
  }

  /// If a case has no usable checkpoint, its next run starts anew and replaces the damaged file first. So
  /// nothing is lost if the file is removed.
  void check_checkpoints() {
    for (const DamagedCheckpoint& checkpoint : damaged_checkpoints(runs_, database_)) {
      const std::string what = checkpoint.path.string() + " " + checkpoint.reason + ": the case ";
      if (checkpoint.resumes_from.empty())
        report(what + "starts anew", [&] { fs::remove(checkpoint.path); });
      else
        findings_.push_back(
            {what + "goes on from " + checkpoint.resumes_from.filename().string(), Finding::Kind::note});
    }
  }

  const fs::path data_, runs_;
  const bool repairs_;
  Database database_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> examine(const fs::path& data, bool repair) {
  expect_data_directory(data);
  std::optional<DataDirectory> locked;
  if (repair) locked.emplace(data);
  return Doctor(data, repair).findings();
}

}  // namespace capstan
