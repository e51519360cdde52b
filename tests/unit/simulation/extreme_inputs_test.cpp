// Extreme values of every numeric key of a case: they are refused with a reason, or the first step is
// computed.
#include <gtest/gtest.h>

#include "solver/case/parse.hpp"
#include "solver/simulation/simulation.hpp"
#include "tests/support/memory_output.hpp"

namespace capstan {
namespace {

using nlohmann::json;

/// A key and the ends of its range that are cheap to run.
struct Key {
  const char* pointer;
  std::vector<double> ends;
};

const std::vector<Key> kKeys = {{"/Ca", {1e-4, 100}},
                                {"/V", {0.01, 100}},
                                {"/Re", {1e-6, 10}},
                                {"/E_b", {10}},
                                {"/C", {1000}},
                                {"/c0", {-100, 100}},
                                {"/aspect", {1, 5}},
                                {"/until/kt", {1e-6, 10000}},
                                {"/outputs/history_every", {1e-6, 1}},
                                {"/outputs/shapes_every", {1e-6, 10000}},
                                {"/outputs/checkpoint_every", {1000000}},
                                {"/fidelity/dx", {0.5}},
                                {"/fidelity/box", {4, 100}},
                                {"/fidelity/nodes", {12}},
                                {"/fidelity/kdt", {1e-6, 1}},
                                {"/fidelity/tolerance", {1e-12, 0.1}}};

const std::vector<json> kBases = {
    json::parse(R"({"Ca": 0.1, "fluid": "stokes", "fidelity": {"nodes": 42}})"),
    json::parse(R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 42}})"),
    json::parse(
        R"({"Ca": 0.1, "fluid": "quasisteady", "fidelity": {"scheme": "paper", "dx": 0.4, "box": 6.4, "nodes": 42}})"),
    json::parse(R"({"Ca": 0.1, "fluid": "unsteady", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 42}})"),
    json::parse(R"({"Ca": 0.1, "fluid": "transient", "fidelity": {"dx": 0.4, "box": 6.4, "nodes": 42}})")};

/// A case in which the key has an effect.
json with(json object, const std::string& pointer, double value) {
  if (pointer == "/C") object["law"] = "skalak";
  if (pointer == "/c0") object["E_b"] = 0.01;
  if (pointer == "/aspect") object["shape"] = "prolate";
  if (pointer == "/fidelity/kdt") object["fidelity"]["stepper"] = "ab2";
  if (pointer == "/fidelity/tolerance") object["V"] = 2;
  object[json::json_pointer(pointer)] = value;
  return object;
}

void expect_a_step_or_a_reason(const Case& c, const json& object) {
  testing::MemoryOutput output;
  output.interruption_wanted = true;
  Simulation simulation(c);
  const Outcome outcome = simulation.run(output);
  const bool went_on = outcome.stop == Stop::interrupted || outcome.stop == Stop::reached_end;
  EXPECT_TRUE(went_on || outcome.message.size() > 20) << object << to_string(outcome.stop);
  if (went_on) {
    EXPECT_EQ(simulation.statistics().steps, 1) << object;
  }
  for (const Record& record : output.records)
    EXPECT_TRUE(std::isfinite(record["D_xy"] + record["volume"])) << object;
}

void expect_refused_or_run(const json& object) {
  const ParsedCase parsed = parse_case(object);
  if (parsed.value) return expect_a_step_or_a_reason(*parsed.value, object);
  EXPECT_FALSE(parsed.issues.empty()) << object;
  for (const Issue& issue : parsed.issues) EXPECT_GT(issue.message.size(), 10u) << object;
}

TEST(ExtremeInputs, AreRefusedWithAReasonOrTakeTheirFirstStep) {
  for (const json& base : kBases)
    for (const Key& key : kKeys) {
      std::vector<double> values = {0, -0.0, -1, 5e-324, 1e-18, 1e18, 1e300};
      values.insert(values.end(), key.ends.begin(), key.ends.end());
      for (double value : values) expect_refused_or_run(with(base, key.pointer, value));
    }
}

}  // namespace
}  // namespace capstan
