#include "runner/worker/tradeoff.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstring>

#include "runner/worker/peak_memory.hpp"
#include "solver/case/parse.hpp"

namespace capstan {
namespace {

using nlohmann::json;

const TradeoffScene kScene = {"sphere", {{"Ca", 0.1}, {"until", {{"kt", 1}}}}};

TradeoffModel coarse_boundary_integrals() {
  return {"stokes",
          {{"rung", {{"nodes", 42}}}, {"rung", {{"nodes", 162}}}, {"rung", {{"nodes", 642}}}},
          {{"symmetry", {{"nodes", 162}, {"symmetry", "none"}}}, {"dx", {{"nodes", 162}, {"dx", 0.1}}}}};
}

class Tradeoff : public ::testing::Test {
 protected:
  /// Of all settings, measured once for all tests.
  static const std::vector<TradeoffRow>& rows() {
    static const std::vector<TradeoffRow> all = [] {
      std::vector<TradeoffRow> found;
      measure_tradeoff(kScene, coarse_boundary_integrals(),
                       [&](const TradeoffRow& row) { found.push_back(row); });
      return found;
    }();
    return all;
  }
};

TEST_F(Tradeoff, FinestRungIsTheReferenceOfAllRows) {
  EXPECT_EQ(rows()[0]["setting"], "nodes 642");
  EXPECT_TRUE(rows()[0]["error_Q"].is_null());
  for (const TradeoffRow& row : rows()) EXPECT_EQ(row["reference"], "nodes 642");
}

TEST_F(Tradeoff, ErrorGrowsFromRungToRungDownwards) {
  EXPECT_GT(rows()[1]["error_Q"], 0);
  EXPECT_GT(rows()[2]["error_Q"], rows()[1]["error_Q"]);
}

TEST_F(Tradeoff, FlowWithoutItsSymmetryIsAsAccurate) {
  ASSERT_EQ(rows()[3]["knob"], "symmetry");
  EXPECT_NEAR(rows()[3]["error_Q"].get<double>(), rows()[1]["error_Q"].get<double>(), 1e-5);
}

TEST_F(Tradeoff, SettingThatTheModelDoesNotHaveIsARowWithTheReason) {
  EXPECT_EQ(rows()[4]["stop"], "refused");
  EXPECT_THAT(rows()[4]["message"].get<std::string>(), ::testing::HasSubstr("no effect"));
  EXPECT_TRUE(rows()[4]["seconds"].is_null());
}

TEST_F(Tradeoff, RungThatIsTooCostlyIsNotRun) {
  TradeoffScene long_scene = kScene;
  long_scene.capsule["until"]["kt"] = 60;
  TradeoffModel model{"stokes", {{"rung", {{"nodes", 162}}}, {"rung", {{"nodes", 40962}}}}, {}};
  const auto reference = measure_tradeoff(long_scene, model, [](const TradeoffRow&) {});
  ASSERT_TRUE(reference.has_value());
  EXPECT_EQ(reference->setting, "nodes 162");
}

TEST(TradeoffReference, DistanceOfTheModelsIsThatOfTheirReferences) {
  History near(1), far(1);
  near[0]["kt"] = far[0]["kt"] = 1, near[0]["theta"] = far[0]["theta"] = 0;
  near[0]["D_xy"] = 0.3, far[0]["D_xy"] = 0.25;
  const TradeoffRow row =
      distance_of_models(kScene, {"quasisteady", "dx 0.1", near}, {"stokes", "nodes 642", far});
  EXPECT_NEAR(row["error_D"].get<double>(), 0.05, 1e-12);
  EXPECT_EQ(row["reference"], "nodes 642");
}

TEST(TradeoffTable, EverySceneIsAValidCaseAtEveryRung) {
  for (const TradeoffScene& scene : tradeoff_scenes())
    for (const TradeoffModel& model : {boundary_integral_settings(), lattice_settings()})
      for (const TradeoffSetting& rung : model.rungs) {
        json object = scene.capsule;
        object["fluid"] = model.fluid;
        object["fidelity"] = rung.fidelity;
        EXPECT_TRUE(parse_case(object).value.has_value()) << object;
      }
}

TEST(PeakMemory, IsThatSinceTheLastStart) {
  if (!restart_peak_memory()) GTEST_SKIP() << "the kernel does not reset it";
  const double before = peak_memory_mb().value();
  constexpr std::size_t kBytes = 64 << 20;  // mapped here, as an allocator may keep what is freed
  void* block = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(block, MAP_FAILED);
  std::memset(block, 1, kBytes);
  munmap(block, kBytes);
  EXPECT_GT(peak_memory_mb().value(), before + 60);
  restart_peak_memory();
  EXPECT_LT(peak_memory_mb().value(), before + 30);
}

}  // namespace
}  // namespace capstan
