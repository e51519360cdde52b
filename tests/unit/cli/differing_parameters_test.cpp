#include "runner/cli/differing_parameters.hpp"

#include <gmock/gmock.h>

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(DifferingParameters, AreThoseWhoseValuesAreNotTheSameInAllCases) {
  const ordered_json one = {
      {"Ca", 0.1}, {"V", 4}, {"until", ordered_json::object()}, {"fidelity", {{"nodes", 162}}}};
  ordered_json other = one;
  EXPECT_THAT(differing_parameters({one, other}), IsEmpty());
  other["Ca"] = 0.2;
  other["fidelity"]["nodes"] = 642;
  other["E_b"] = 0.01;
  EXPECT_THAT(differing_parameters({one, one, other}), ElementsAre("/Ca", "/fidelity/nodes", "/E_b"));
  EXPECT_EQ(name_of_parameter("/fidelity/nodes"), "fidelity.nodes");
  EXPECT_TRUE(parameter_at(one, "/E_b").is_null());
}

TEST(DifferingParameters, OfOneCaseAreNone) { EXPECT_THAT(differing_parameters({{{"Ca", 0.1}}}), IsEmpty()); }

}  // namespace
}  // namespace capstan
