#include "runner/render/phase_diagram_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Over Ca and V, with a motion, a failed and a queued case.
PhaseDiagram diagram() {
  return {.x = {"Ca", {0.25, 0.75}},
          .y = {"V", {2, 4}},
          .at = {},
          .rows = {{{"tank_treading", "done", {"a"}}, {"", "failed", {"b"}}},
                   {{"tumbling", "done", {"c"}}, {"", "queued", {"d"}}}}};
}

TEST(PhaseDiagramText, HasYUpwardsAndALegendOfTheMarksThatOccur) {
  EXPECT_EQ(phase_diagram_text(diagram(), false),
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

TEST(PhaseDiagramText, LeavesOutColumnsThatFewRowsHaveAndCountsTheirPoints) {
  PhaseDiagram sparse = diagram();
  sparse.x.values.insert(sparse.x.values.begin() + 1, 0.3);
  sparse.y.values.push_back(6);
  sparse.rows.push_back(sparse.rows[1]);
  for (auto& row : sparse.rows) row.insert(row.begin() + 1, PhaseCell{});
  sparse.rows[0][1] = {"tank_treading", "done", {"e"}};
  const std::string text = phase_diagram_text(sparse, false);
  EXPECT_THAT(text, Not(HasSubstr("0.3")));
  EXPECT_THAT(text, HasSubstr("Points at other values, which capstan results lists: 1\n"));
}

TEST(PhaseDiagramText, NamesTheValuesOfTheAxesThatAreNotDrawn) {
  PhaseDiagram section = diagram();
  section.at["E_b"] = 0.01;
  EXPECT_THAT(phase_diagram_text(section, false), HasSubstr("\nat E_b = 0.01\n"));
}

TEST(PhaseDiagramText, NamesBothReasonsForAnUndecidedLabel) {
  PhaseDiagram undecided = diagram();
  undecided.rows[0][0].motion = "undecided";
  EXPECT_THAT(phase_diagram_text(undecided, false),
              HasSubstr("undecided: the run was too short, or its surface was lost\n"));
}

TEST(PhaseDiagramText, HasUnconfirmedMotionsInSmallLettersAndSaysWhatTheyMean) {
  PhaseDiagram doubtful = diagram();
  EXPECT_THAT(phase_diagram_text(doubtful, false), Not(HasSubstr("not confirmed")));
  doubtful.rows[0][0].is_confirmed = false;
  EXPECT_THAT(phase_diagram_text(doubtful, false), HasSubstr(" 2 |  tt    !\n"));
  EXPECT_THAT(phase_diagram_text(doubtful, false), HasSubstr("In small letters: not confirmed."));
}

TEST(PhaseDiagramText, HasEscapeCodesOnlyInColour) {
  EXPECT_THAT(phase_diagram_text(diagram(), false), Not(HasSubstr("\x1b")));
  EXPECT_THAT(phase_diagram_text(diagram(), true), HasSubstr("\x1b[1;97;41m"));
}

}  // namespace
}  // namespace capstan
