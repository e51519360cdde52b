#include "runner/results/phase_diagram.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

using nlohmann::ordered_json;

ordered_json study_over(std::initializer_list<std::pair<const char*, ordered_json>> axes) {
  ordered_json study = {{"axes", ordered_json::array()}};
  for (const auto& [parameter, values] : axes)
    study["axes"].push_back({{"parameter", parameter}, {"values", values}});
  return study;
}

ordered_json case_with(const ordered_json& parameters, const ordered_json& motion,
                       const std::string& state = "done") {
  return {{"id", parameters.dump()}, {"parameters", parameters}, {"motion", motion}, {"state", state}};
}

const ordered_json kStudy = study_over({{"Ca", {0.75, 0.25}}, {"V", {2, 4}}});
const ordered_json kCases = {case_with({{"Ca", 0.25}, {"V", 2}}, "tank_treading"),
                             case_with({{"Ca", 0.25}, {"V", 4}}, "tumbling"),
                             case_with({{"Ca", 0.75}, {"V", 2}}, nullptr, "failed"),
                             case_with({{"Ca", 0.75}, {"V", 4}}, nullptr, "queued")};

TEST(PhaseDiagram, HasTheFirstAxisAcrossAndTheSecondUpwardsInAscendingOrder) {
  const auto diagram = phase_diagram(kStudy, kCases);
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->x.parameter, "Ca");
  EXPECT_EQ(diagram->x.values, (std::vector<ordered_json>{0.25, 0.75}));
  EXPECT_EQ(diagram->rows[1][0].motion, "tumbling");
  EXPECT_EQ(diagram->rows[0][0].motion, "tank_treading");
  EXPECT_EQ(diagram->rows[0][1].state, "failed");
}

TEST(PhaseDiagram, AxesMayBeChosen) {
  const auto diagram = phase_diagram(kStudy, kCases, "V", "Ca");
  EXPECT_EQ(diagram->x.parameter, "V");
  EXPECT_EQ(diagram->rows[0][1].motion, "tumbling");
  EXPECT_FALSE(phase_diagram(kStudy, kCases, "C"));
  EXPECT_FALSE(phase_diagram(kStudy, kCases, "Ca", "Ca"));
}

TEST(PhaseDiagram, CasesThatDifferAtOnePointAreMixed) {
  ordered_json cases = kCases;
  cases.push_back(case_with({{"Ca", 0.25}, {"V", 4}, {"E_b", 1}}, "tank_treading"));
  const auto diagram = phase_diagram(kStudy, cases);
  EXPECT_EQ(diagram->rows[1][0].motion, "mixed");
  EXPECT_EQ(diagram->rows[1][0].cases.size(), 2u);
}

TEST(PhaseDiagram, OfOneAxisHasOneRow) {
  const auto diagram = phase_diagram(study_over({{"Ca", {0.25, 0.75}}}), kCases);
  ASSERT_EQ(diagram->rows.size(), 1u);
  EXPECT_EQ(diagram->y.parameter, "");
}

TEST(PhaseDiagram, NeedsAnAxis) { EXPECT_FALSE(phase_diagram(study_over({}), kCases)); }

TEST(PhaseDiagram, SurvivesItsJourneyAsJson) {
  const auto diagram = phase_diagram(kStudy, kCases);
  const ordered_json json = to_json(*diagram);
  EXPECT_EQ(to_json(phase_diagram_from_json(ordered_json::parse(json.dump()))), json);
}

TEST(PhaseDiagram, IsDrawnWithYUpwardsAndALegendOfWhatItShows) {
  EXPECT_EQ(render(*phase_diagram(kStudy, kCases), false),
            " V\n"
            " 4 |  TB    .\n"
            " 2 |  TT    !\n"
            "   +------------\n"
            "     0.25  0.75   Ca\n"
            "\n"
            " TB   tumbling\n"
            " TT   tank-treading\n"
            " !    failed\n"
            " .    queued\n");
}

TEST(PhaseDiagram, HasEscapeCodesOnlyForATerminal) {
  const auto diagram = phase_diagram(kStudy, kCases);
  EXPECT_EQ(render(*diagram, false).find('\x1b'), std::string::npos);
  EXPECT_NE(render(*diagram, true).find("\x1b[1;97;41m"), std::string::npos);
}

}  // namespace
}  // namespace capstan
