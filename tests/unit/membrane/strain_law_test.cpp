#include "solver/membrane/strain_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/membrane/neo_hookean.hpp"
#include "solver/membrane/skalak.hpp"

namespace capstan {
namespace {

Principal pair(double lambda1, double lambda2) {
  Principal one(1, 2);
  one << lambda1, lambda2;
  return one;
}

class StrainLaws : public ::testing::TestWithParam<std::shared_ptr<const StrainLaw>> {
 protected:
  double energy(double lambda1, double lambda2) const {
    return GetParam()->energy(pair(lambda1, lambda2))[0];
  }
  double d1(double lambda1, double lambda2) const {
    return GetParam()->derivatives(pair(lambda1, lambda2))(0, 0);
  }
  double d2(double lambda1, double lambda2) const {
    return GetParam()->derivatives(pair(lambda1, lambda2))(0, 1);
  }
};

std::string law_name(const ::testing::TestParamInfo<std::shared_ptr<const StrainLaw>>& law) {
  return law.index == 0 ? "NeoHookean" : law.index == 1 ? "SkalakC0" : "SkalakC5";
}

INSTANTIATE_TEST_SUITE_P(Each, StrainLaws,
                         ::testing::Values(std::make_shared<NeoHookean>(), std::make_shared<Skalak>(0),
                                           std::make_shared<Skalak>(5)),
                         law_name);

TEST_P(StrainLaws, EnergyAndTensionVanishAtRest) {
  EXPECT_DOUBLE_EQ(energy(1, 1), 0);
  EXPECT_DOUBLE_EQ(d1(1, 1), 0);
  EXPECT_DOUBLE_EQ(d2(1, 1), 0);
}

TEST_P(StrainLaws, DerivativesAreThoseOfTheEnergy) {
  const double h = 1e-5;
  for (double lambda1 : {0.7, 1.0, 1.3, 2.0})
    for (double lambda2 : {0.6, 1.0, 1.4}) {
      EXPECT_NEAR(d1(lambda1, lambda2),
                  (energy(lambda1 + h, lambda2) - energy(lambda1 - h, lambda2)) / (2 * h), 1e-8);
      EXPECT_NEAR(d2(lambda1, lambda2),
                  (energy(lambda1, lambda2 + h) - energy(lambda1, lambda2 - h)) / (2 * h), 1e-8);
    }
}

TEST_P(StrainLaws, TreatBothDirectionsAlike) {
  EXPECT_DOUBLE_EQ(energy(1.3, 0.8), energy(0.8, 1.3));
  EXPECT_DOUBLE_EQ(d1(1.3, 0.8), d2(0.8, 1.3));
}

/// A small uniaxial tension stretches by  tau / E_s'  and shears with modulus G: both follow from the
/// quadratic part of W,  W = 1/2 [ (K + G)(e1^2 + e2^2) + 2 (K - G) e1 e2 ].
struct SmallStrainModuli {
  double shear, area;
};

SmallStrainModuli moduli(const StrainLaw& law) {
  const double e = 1e-5;
  const double pure_shear =
      law.derivatives(pair(1 + e, 1 - e))(0, 0) - law.derivatives(pair(1 - e, 1 + e))(0, 0);
  const double dilation =
      law.derivatives(pair(1 + e, 1 + e))(0, 0) - law.derivatives(pair(1 - e, 1 - e))(0, 0);
  return {pure_shear / (4 * e), dilation / (4 * e)};
}

TEST(NeoHookean, ShearModulusIsAThirdOfEsAndAreaModulusIsEs) {
  const auto [shear, area] = moduli(NeoHookean());
  EXPECT_NEAR(shear, 1.0 / 3, 1e-8);
  EXPECT_NEAR(area, 1, 1e-8);
}

TEST(Skalak, ShearModulusIsHalfOfEsAndAreaModulusGrowsWithC) {
  for (double C : {0.0, 1.0, 5.0, 50.0}) {
    const auto [shear, area] = moduli(Skalak(C));
    EXPECT_NEAR(shear, 0.5, 1e-7);
    EXPECT_NEAR(area, (1 + 2 * C) / 2, 1e-6);
  }
}

TEST(StrainLaw, TheCaseDecidesWhichLawIsMade) {
  Case c;
  EXPECT_TRUE(dynamic_cast<const NeoHookean*>(make_strain_law(c).get()));
  c.law = Law::skalak;
  c.C = 5;
  const auto law = make_strain_law(c);
  EXPECT_DOUBLE_EQ(law->energy(pair(1.2, 1.1))[0], Skalak(5).energy(pair(1.2, 1.1))[0]);
}

}  // namespace
}  // namespace capstan
