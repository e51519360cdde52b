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

class Doctor {
 public:
  Doctor(const std::filesystem::path& data, bool mend)
      : data_(data),
        mend_(mend),
        database_(data / "capstan.sqlite", mend ? Database::Access::write : Database::Access::read) {}

  std::vector<Finding> findings() && {
    look_at_disk();
    if (look_at_database()) {
      find_run_faults(data_ / "runs", database_,
                      [this](const std::string& what, const auto& mend) { found(what, mend); });
      look_at_checkpoints();
    }
    return std::move(findings_);
  }

 private:
  void found(const std::string& what, const std::function<void()>& mend) {
    if (mend_ && mend) mend();
    findings_.push_back({what, mend_ && mend ? Finding::Kind::mended : Finding::Kind::fault});
  }

  void look_at_disk() {
    if (!std::filesystem::exists(data_ / "runs"))
      found((data_ / "runs").string() + " is missing",
            [this] { std::filesystem::create_directories(data_ / "runs"); });
    for (const std::filesystem::path& place : {data_, data_ / "runs"})
      if (std::filesystem::exists(place) && std::filesystem::space(place).available < kMinFree)
        found("less than " + std::to_string(kMinFree / 1'000'000) + " MB are free in " + place.string(), {});
  }

  /// False if it is damaged: then nothing that it says can be relied on.
  bool look_at_database() {
    std::vector<std::string> damage = damage_of(database_);
    if (!damage.empty() && mend_) {
      database_.execute_script("REINDEX");
      const bool is_mended = damage_of(database_).empty();
      for (const std::string& fault : damage)
        findings_.push_back(
            {"the database: " + fault, is_mended ? Finding::Kind::mended : Finding::Kind::fault});
      if (!is_mended) return false;
    } else if (!damage.empty()) {
      for (const std::string& fault : damage) found("the database: " + fault, {});
      return false;
    }
    for (const std::string& study : miscounted_studies(database_))
      found("the sums of study " + study + " are not those of its cases", [this] {
        Transaction transaction(database_);
        database_.execute_script(kRecount);
        transaction.commit();
      });
    return true;
  }

  /// What cannot be read is worth nothing: to take it away is safe, and the next run would replace it first.
  void look_at_checkpoints() {
    for (const DamagedCheckpoint& checkpoint : damaged_checkpoints(data_ / "runs", database_)) {
      const std::string what = checkpoint.path.string() + " " + checkpoint.fault + ": the case ";
      if (checkpoint.other.empty())
        found(what + "starts anew", [&] { std::filesystem::remove(checkpoint.path); });
      else
        findings_.push_back(
            {what + "goes on from " + checkpoint.other.filename().string(), Finding::Kind::note});
    }
  }

  const std::filesystem::path data_;
  const bool mend_;
  Database database_;
  std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> examine(const std::filesystem::path& data, bool mend) {
  if (!std::filesystem::exists(data / "capstan.sqlite"))
    throw std::runtime_error(data.string() + " is no data directory: it holds no capstan.sqlite");
  std::optional<DataDirectory> held;
  if (mend) held.emplace(data);
  return Doctor(data, mend).findings();
}

}  // namespace capstan
