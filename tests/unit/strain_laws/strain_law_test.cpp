#include "solver/strain_laws/strain_law.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/materials.hpp"

namespace capstan {
namespace {

using namespace capstan::testing;

Principal pair(double lambda1, double lambda2) {
  Principal one(1, 2);
  one << lambda1, lambda2;
  return one;
}

double energy(const Material& material, double lambda1, double lambda2) {
  return material.law->energy(pair(lambda1, lambda2), material.constants)[0];
}

/// dW/dlambda_i at the stretches. \param direction  i - 1
double derivative(const Material& material, double lambda1, double lambda2, int direction = 0) {
  return material.law->derivatives(pair(lambda1, lambda2), material.constants)(0, direction);
}

/// From the second differences of W about rest, by the quadratic form at SmallStrainModuli.
SmallStrainModuli moduli_of_energy(const Material& material) {
  const double e = 1e-5;
  const double shear = derivative(material, 1 + e, 1 - e) - derivative(material, 1 - e, 1 + e);
  const double dilation = derivative(material, 1 + e, 1 + e) - derivative(material, 1 - e, 1 - e);
  return {shear / (4 * e), dilation / (4 * e)};
}

class StrainLaws : public ::testing::TestWithParam<Material> {};
INSTANTIATE_TEST_SUITE_P(Each, StrainLaws, ::testing::ValuesIn(all_materials()),
                         [](const auto& test) { return name_of(test.param); });

TEST_P(StrainLaws, EnergyAndTensionVanishAtRest) {
  EXPECT_DOUBLE_EQ(energy(GetParam(), 1, 1), 0);
  EXPECT_DOUBLE_EQ(derivative(GetParam(), 1, 1, 0), 0);
  EXPECT_DOUBLE_EQ(derivative(GetParam(), 1, 1, 1), 0);
}

TEST_P(StrainLaws, DerivativesAreThoseOfTheEnergy) {
  const double h = 1e-5;
  for (double lambda1 : {0.7, 1.0, 1.3, 2.0})
    for (double lambda2 : {0.6, 1.0, 1.4}) {
      const auto W = [&](double d1, double d2) { return energy(GetParam(), lambda1 + d1, lambda2 + d2); };
      EXPECT_NEAR(derivative(GetParam(), lambda1, lambda2, 0), (W(h, 0) - W(-h, 0)) / (2 * h), 1e-8);
      EXPECT_NEAR(derivative(GetParam(), lambda1, lambda2, 1), (W(0, h) - W(0, -h)) / (2 * h), 1e-8);
    }
}

TEST_P(StrainLaws, TreatBothDirectionsAlike) {
  EXPECT_DOUBLE_EQ(energy(GetParam(), 1.3, 0.8), energy(GetParam(), 0.8, 1.3));
  EXPECT_DOUBLE_EQ(derivative(GetParam(), 1.3, 0.8, 0), derivative(GetParam(), 0.8, 1.3, 1));
}

TEST_P(StrainLaws, HaveTheSmallStrainModuliThatTheyState) {
  const SmallStrainModuli stated = GetParam().law->moduli(GetParam().constants);
  const SmallStrainModuli measured = moduli_of_energy(GetParam());
  EXPECT_NEAR(measured.shear, stated.shear, 1e-7);
  EXPECT_NEAR(measured.area, stated.area, 1e-6);
}

TEST(NeoHookean, ShearModulusIsAThirdOfEsAndAreaModulusIsEs) {
  const auto [shear, area] = moduli_of_energy({find_strain_law("neo-hookean"), {}});
  EXPECT_NEAR(shear, 1.0 / 3, 1e-8);
  EXPECT_NEAR(area, 1, 1e-8);
}

TEST(Skalak, ShearModulusIsHalfOfEsAndAreaModulusGrowsWithC) {
  for (double C : {0.0, 1.0, 5.0, 50.0}) {
    const auto [shear, area] = moduli_of_energy({find_strain_law("skalak"), {C}});
    EXPECT_NEAR(shear, 0.5, 1e-7);
    EXPECT_NEAR(area, (1 + 2 * C) / 2, 1e-6);
  }
}

TEST(Skalak, AdvisesMoreResistanceToDilationWhereItIsSmall) {
  const StrainLaw& skalak = *find_strain_law("skalak");
  EXPECT_EQ(skalak.advice_on_collapse({0.25}),
            "Skalak's law with C = 0.25 loses its resistance where the membrane is compressed to less than "
            "0.58: raise C to 0.5 or more, or lower Ca.");
  EXPECT_EQ(skalak.advice_on_collapse({0.5}), "");
}

TEST(StrainLawTable, NamesAreDifferentAndTheDefaultIsNeoHookean) {
  std::set<std::string_view> names;
  for (const StrainLaw& law : strain_laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    EXPECT_EQ(find_strain_law(law.name), &law);
  }
  EXPECT_EQ(default_strain_law(), find_strain_law("neo-hookean"));
  EXPECT_EQ(find_strain_law("mooney-rivlin"), nullptr);
}

}  // namespace
}  // namespace capstan
