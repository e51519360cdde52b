#include "solver/case/nearest_word.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

const std::vector<std::string> kKeys = {"shape", "aspect", "law", "C",       "Ca",
                                        "V",     "Re",     "E_b", "bending", "c0"};
const std::vector<std::string> kCommands = {"submit", "studies", "show", "results", "phase-diagram"};

std::string nearest(const std::string& typed, const std::vector<std::string>& candidates) {
  return nearest_word(typed, candidates).value_or("");
}

TEST(NearestWord, DiffersInCapitalsAndHyphens) {
  EXPECT_EQ(nearest("Skalak", {"neo-hookean", "skalak"}), "skalak");
  EXPECT_EQ(nearest("Neo Hookean", {"neo-hookean", "skalak"}), "neo-hookean");
  EXPECT_EQ(nearest("ca", kKeys), "Ca");
  EXPECT_EQ(nearest("c", kKeys), "C");
  EXPECT_EQ(nearest("Eb", kKeys), "E_b");
}

TEST(NearestWord, IsAFewTypingErrorsAway) {
  EXPECT_EQ(nearest("sumbit", kCommands), "submit");
  EXPECT_EQ(nearest("result", kCommands), "results");
  EXPECT_EQ(nearest("studys", kCommands), "studies");
  EXPECT_EQ(nearest("phase_diagramm", kCommands), "phase-diagram");
  EXPECT_EQ(nearest("skallak", {"neo-hookean", "skalak"}), "skalak");
}

TEST(NearestWord, MayBeTheBeginningOfALongerOne) {
  EXPECT_EQ(nearest("phase", kCommands), "phase-diagram");
  EXPECT_EQ(nearest("neo", {"neo-hookean", "skalak"}), "neo-hookean");
}

TEST(NearestWord, IsNoneWhereNothingIsNear) {
  EXPECT_EQ(nearest("colour", kKeys), "");
  EXPECT_EQ(nearest("fly", kCommands), "");
  EXPECT_EQ(nearest("Cb", kKeys), "");
  EXPECT_EQ(nearest("", kKeys), "");
  EXPECT_EQ(nearest(std::string(100'000, 'a'), kKeys), "");
}

TEST(NearestWord, EndsAMessage) {
  EXPECT_EQ(suggestion("Skalak", {"neo-hookean", "skalak"}), "; did you mean \"skalak\"?");
  EXPECT_EQ(suggestion("mooney", {"neo-hookean", "skalak"}), "");
}

}  // namespace
}  // namespace capstan
