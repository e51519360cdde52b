// A new strain law is one file and one row. CMake adds the row STRAIN_LAW(evans_skalak) to the table and the
// file evans_skalak.cpp to the program; everything else is the library as it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/case/json_schema.hpp"
#include "solver/case/parse.hpp"
#include "solver/membrane/membrane.hpp"
#include "solver/mesh/icosphere.hpp"
#include "tests/support/forces.hpp"
#include "tests/support/materials.hpp"

namespace capstan {
namespace {

using namespace capstan::testing;
using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const json kCapsule = {{"Ca", 0.1}, {"law", "evans-skalak"}, {"K", 3}};

TEST(NewStrainLaw, IsAcceptedInCaseFilesWithItsConstant) {
  const Case c = parse_case(kCapsule).value.value();
  EXPECT_EQ(c.law->name, "evans-skalak");
  EXPECT_THAT(c.law_constants, ElementsAre(3));
  EXPECT_EQ(parse_case(json(to_json(c))).value.value(), c);
}

TEST(NewStrainLaw, NeedsItsConstantInItsRange) {
  const auto only_issue = [](const json& document) { return parse_case(document).issues.at(0); };
  EXPECT_EQ(only_issue({{"Ca", 0.1}, {"law", "evans-skalak"}}),
            (Issue{"/K", "is missing: the area modulus over E_s"}));
  EXPECT_EQ(only_issue({{"Ca", 0.1}, {"law", "evans-skalak"}, {"K", 0}}),
            (Issue{"/K", "is 0, must be >= 0.1 and <= 1000"}));
  EXPECT_EQ(only_issue({{"Ca", 0.1}, {"law", "skalak"}, {"C", 1}, {"K", 3}}),
            (Issue{"/K", "has no effect: only the evans-skalak law has the constant K", true}));
  EXPECT_THAT(only_issue({{"Ca", 0.1}, {"law", "evans skalak"}, {"K", 3}}).message,
              HasSubstr("did you mean \"evans-skalak\"?"));
}

TEST(NewStrainLaw, StandsInTheJsonSchemaWithItsConstant) {
  const json properties = case_schema()["properties"];
  EXPECT_THAT(properties["law"]["enum"], Contains("evans-skalak"));
  EXPECT_THAT(std::string(properties["law"]["description"]), HasSubstr("evans-skalak (E_s = 2 G)"));
  EXPECT_EQ(properties["K"], json::parse(R"({"type": "number", "minimum": 0.1, "maximum": 1000,
      "description": "the area modulus over E_s; required for the evans-skalak law."})"));
}

TEST(NewStrainLaw, ItsConstantCanBeAnAxisOfAStudy) { EXPECT_THAT(scalar_parameters(), Contains("K")); }

TEST(NewStrainLaw, MakesAMembraneWhoseForcesAreTheGradientOfItsEnergy) {
  const Case c = parse_case(kCapsule).value.value();
  const Icosphere sphere = make_icosphere(2);
  const Membrane membrane(c, sphere.mesh, sphere.directions,
                          Orbits::without_symmetry(sphere.mesh.vertex_count()));
  const Points x = bumped(sphere.directions, 0.05);
  Points forces;
  membrane.forces(x, forces);
  const auto energy = [&](const Points& positions) { return *membrane.energy(positions); };
  EXPECT_LT(relative_error(negative_gradient(energy, x), forces), 1e-7);
}

}  // namespace
}  // namespace capstan
