#include "runner/queries/phase_diagram.hpp"

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

PointMotion point_with(const nlohmann::json& asked, const std::string& motion,
                       const std::string& state = "done") {
  return {asked.dump(), state, motion, asked};
}

const ordered_json kStudy = study_over({{"Ca", {0.75, 0.25}}, {"V", {2, 4}}});
const std::vector<PointMotion> kPoints = {
    point_with({{"Ca", 0.25}, {"V", 2}}, "tank_treading"), point_with({{"Ca", 0.25}, {"V", 4}}, "tumbling"),
    point_with({{"Ca", 0.75}, {"V", 2}}, "", "failed"), point_with({{"Ca", 0.75}, {"V", 4}}, "", "queued")};

/// Over three axes; tumbling at E_b = 0.01 alone.
const ordered_json kThreeAxes = study_over({{"Ca", {0.25, 0.75}}, {"V", {2, 4}}, {"E_b", {0, 0.01}}});
std::vector<PointMotion> points_of_three_axes() {
  std::vector<PointMotion> points;
  for (const PointMotion& point : kPoints)
    for (const double E_b : {0.0, 0.01}) {
      points.push_back(point);
      points.back().asked["E_b"] = E_b;
      points.back().motion = E_b > 0 ? "tumbling" : "tank_treading";
    }
  return points;
}

std::string issue_of(const ordered_json& study, const DiagramRequest& wanted) {
  const ParsedDiagram parsed = phase_diagram(study, {}, wanted);
  return parsed.issues.size() == 1 ? parsed.issues[0].pointer + ": " + parsed.issues[0].message
                                   : std::to_string(parsed.issues.size()) + " issues";
}

TEST(PhaseDiagram, HasTheFirstAxisAcrossAndTheSecondUpwardsInAscendingOrder) {
  const auto diagram = phase_diagram(kStudy, kPoints).value;
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->x.parameter, "Ca");
  EXPECT_EQ(diagram->x.values, (std::vector<nlohmann::json>{0.25, 0.75}));
  EXPECT_EQ(diagram->rows[1][0].motion, "tumbling");
  EXPECT_EQ(diagram->rows[0][0].motion, "tank_treading");
  EXPECT_EQ(diagram->rows[0][1].state, "failed");
}

TEST(PhaseDiagram, ACellIsConfirmedIfTheMotionsOfAllItsPointsAre) {
  std::vector<PointMotion> points = kPoints;
  points[1].is_confirmed = true;
  points.push_back(points[1]);
  EXPECT_TRUE(phase_diagram(kStudy, points).value->rows[1][0].is_confirmed);
  EXPECT_FALSE(phase_diagram(kStudy, points).value->rows[0][0].is_confirmed);
  points.back().is_confirmed = false;
  const PhaseDiagram diagram = phase_diagram(kStudy, points).value.value();
  EXPECT_FALSE(diagram.rows[1][0].is_confirmed);
  EXPECT_FALSE(phase_diagram_from_json(to_json(diagram)).rows[1][0].is_confirmed);
}

TEST(PhaseDiagram, AxesMayBeChosen) {
  const auto diagram = phase_diagram(kStudy, kPoints, {"V", "Ca", {}}).value;
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->x.parameter, "V");
  EXPECT_EQ(diagram->rows[0][1].motion, "tumbling");
  EXPECT_EQ(issue_of(kStudy, {"C", "", {}}), "x: \"C\" is no axis of the study; its axes are: Ca, V");
  EXPECT_EQ(issue_of(kStudy, {"Ca", "Ca", {}}), "y: is Ca like x; name another axis");
}

TEST(PhaseDiagram, IsDrawnOverTheValuesThatWereAskedFor) {
  const ordered_json study =
      study_over({{"fluid", {"auto", "quasisteady"}}, {"fidelity", {"fast", {{"dx", 0.2}}}}});
  const auto diagram =
      phase_diagram(study,
                    {point_with({{"fluid", "auto"}, {"fidelity", "fast"}}, "tumbling"),
                     point_with({{"fluid", "quasisteady"}, {"fidelity", {{"dx", 0.2}}}}, "transition")})
          .value;
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->rows[0][0].motion, "tumbling");
  EXPECT_EQ(diagram->rows[1][1].motion, "transition");
}

TEST(PhaseDiagram, ThirdAxisIsFixedAtOneOfItsValues) {
  const auto diagram = phase_diagram(kThreeAxes, points_of_three_axes(), {"", "", {"E_b=0.010"}}).value;
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->at.at("E_b"), 0.01);
  for (const auto& row : diagram->rows)
    for (const PhaseCell& cell : row) {
      EXPECT_EQ(cell.cases.size(), 1u);
      EXPECT_EQ(cell.motion, "tumbling");
    }
  const auto other = phase_diagram(kThreeAxes, points_of_three_axes(), {"E_b", "Ca", {"V=2"}}).value;
  ASSERT_TRUE(other);
  EXPECT_EQ(other->rows[0][0].motion, "tank_treading");
  EXPECT_EQ(other->rows[0][1].motion, "tumbling");
}

TEST(PhaseDiagram, AxisThatIsNotFixedIsAnIssueThatListsThePossibleValues) {
  EXPECT_EQ(issue_of(kThreeAxes, {}),
            "at: E_b is not fixed: say at which value, such as E_b=0; it has: 0, 0.01");
  EXPECT_EQ(issue_of(kThreeAxes, {"V", "E_b", {}}),
            "at: Ca is not fixed: say at which value, such as Ca=0.25; it has: 0.25, 0.75");
  EXPECT_EQ(issue_of(kThreeAxes, {"Ca", "V", {"E_b=3"}}), "at: E_b has no value 3; it has: 0, 0.01");
  EXPECT_EQ(issue_of(kThreeAxes, {"Ca", "V", {"E_b=0", "E_b=0.01"}}), "at: E_b is fixed twice");
  EXPECT_EQ(issue_of(kThreeAxes, {"Ca", "V", {"E_b=0", "Ca=0.25"}}),
            "at: Ca is drawn, so it cannot be fixed");
  EXPECT_EQ(issue_of(kThreeAxes, {"Ca", "V", {"E_b=0", "C=1"}}),
            "at: \"C\" is no axis of the study; its axes are: Ca, V, E_b");
  EXPECT_EQ(issue_of(kThreeAxes, {"Ca", "V", {"E_b=0", "E_b"}}),
            "at: \"E_b\" must be AXIS=VALUE, as in E_b=0.015");
}

TEST(PhaseDiagram, AxisOfOneValueIsFixedThereAndDrawnLast) {
  const ordered_json study = study_over({{"Ca", {0.1}}, {"V", {2, 4}}, {"E_b", {0, 0.01}}});
  const auto diagram = phase_diagram(study, {}).value;
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->x.parameter, "V");
  EXPECT_EQ(diagram->y.parameter, "E_b");
  EXPECT_EQ(diagram->at.at("Ca"), 0.1);
}

TEST(PhaseDiagram, OfOneAxisHasOneRow) {
  const auto diagram = phase_diagram(study_over({{"Ca", {0.25, 0.75}}}), kPoints).value;
  ASSERT_EQ(diagram->rows.size(), 1u);
  EXPECT_EQ(diagram->y.parameter, "");
}

TEST(PhaseDiagram, IsReadBackFromItsJson) {
  const ordered_json json =
      to_json(*phase_diagram(kThreeAxes, points_of_three_axes(), {"", "", {"E_b=0"}}).value);
  EXPECT_EQ(to_json(phase_diagram_from_json(ordered_json::parse(json.dump()))), json);
}

}  // namespace
}  // namespace capstan
