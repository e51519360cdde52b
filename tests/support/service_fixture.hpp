#pragma once
// A service with a clock and runs that the test controls.
#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "runner/daemon/service.hpp"
#include "runner/queries/queries.hpp"
#include "tests/support/fake_clock.hpp"
#include "tests/support/fake_executor.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {

class ServiceFixture : public ::testing::Test {
 protected:
  /// Makes a new service on the same data, as after a kill of the daemon.
  void restart() {
    service_.reset();
    service_ = std::make_unique<Service>(data_, executor_, clock_, limits_);
  }

  const RunDirectory& directory_of(const RunHandle& run) { return executor_.directories.at(run); }
  void write_history(const RunHandle& run, const std::string& lines) {
    std::ofstream(directory_of(run).history_file()) << lines;
  }
  void complete(const RunHandle& run, const std::string& motion) {
    std::ofstream(directory_of(run).result_file())
        << nlohmann::json{{"stop", "reached_end"}, {"motion", motion}, {"evidence", {{"turns", 2}}}};
    executor_.exit(run, 0);
  }

  nlohmann::ordered_json study(const std::string& id) {
    const Readers::Reader reader = service_->reader();
    return find_study(*reader, id).value();
  }
  nlohmann::ordered_json cases(const std::string& id, const CaseFilter& filter = {}) {
    const Readers::Reader reader = service_->reader();
    return find_cases(*reader, id, filter, {}).items;
  }

  TemporaryDirectory directory_;
  DataDirectory data_{directory_.path()};
  FakeExecutor executor_;
  FakeClock clock_;
  RunLimits limits_;
  std::unique_ptr<Service> service_ = std::make_unique<Service>(data_, executor_, clock_);
};

/// The tests of the daemon: a study is submitted and its first cases are started at once.
class ServiceTest : public ServiceFixture {
 protected:
  static constexpr auto kHeartbeat = JobQueue::kLease / JobQueue::kHeartbeats;

  std::string submit(const nlohmann::json& axes) {
    const std::string id = service_->submit(sample_study("study", axes)).study_id;
    service_->tick();
    return id;
  }
  Case case_of(const RunHandle& run) {
    return parse_case(nlohmann::json::parse(std::ifstream(directory_of(run).case_file()))).value.value();
  }
};

}  // namespace capstan
