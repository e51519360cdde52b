// The scripts of pictures. The pictures themselves are drawn by gnuplot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "runner/render/history_picture.hpp"
#include "runner/render/phase_diagram_picture.hpp"
#include "runner/render/shape_picture.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Two confirmed motions, one that is not, and a case that failed.
PhaseDiagram small_diagram() {
  return {.x = {"Ca", {0.25, 0.75}},
          .y = {"V", {2, 4}},
          .at = {},
          .rows = {{{"tank_treading", "done", {"a"}, true}, {"transition", "done", {"b"}, false}},
                   {{"tumbling", "done", {"c"}, true}, {"", "failed", {"d"}}}}};
}

std::string phase_script(const PhaseDiagram& of) {
  return phase_diagram_script(of, nullptr, {}, {"fig.svg"});
}

History turning(double kt_end) {
  History history;
  for (double kt = 0; kt <= kt_end; kt += 0.5) {
    Record& record = history.emplace_back();
    record["kt"] = kt;
    record["D_xy"] = 0.3;
    record["theta"] = 0 - kt / 2;
  }
  return history;
}

TEST(PhaseDiagramPicture, HasEachPointOnceInTheSeriesOfItsMotion) {
  const std::string script = phase_script(small_diagram());
  EXPECT_THAT(script, HasSubstr("$tank_treading << END\n0.25 2\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$tumbling << END\n0.25 4\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$transition_not_confirmed << END\n0.75 2\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$failed << END\n0.75 4\nEND\n"));
  EXPECT_THAT(script, Not(HasSubstr("$undecided")));
}

TEST(PhaseDiagramPicture, HasALogarithmicAxisWhereTheValuesSpanMoreThanAFactorOfTwenty) {
  EXPECT_THAT(phase_script(small_diagram()), Not(HasSubstr("set logscale")));
  PhaseDiagram wide = small_diagram();
  wide.x.values = {0.01, 1};
  EXPECT_THAT(phase_script(wide), HasSubstr("set logscale x\n"));
  EXPECT_THAT(phase_script(wide), Not(HasSubstr("set logscale y\n")));
}

TEST(PhaseDiagramPicture, NamesTheWordsOfAnAxisOfWords) {
  PhaseDiagram words = small_diagram();
  words.x = {"shape", {"oblate", "sphere"}};
  EXPECT_THAT(phase_script(words), HasSubstr("set xtics ('oblate' 0, 'sphere' 1)"));
}

const nlohmann::ordered_json kBoundary =
    nlohmann::ordered_json::parse(R"({"along": "Ca", "between": [0.05, 1], "curves": [
  {"from": "tumbling", "to": "tank_treading", "over": "V", "at": {}, "points": [
    {"over": 2, "value": 0.2, "low": 0.19, "high": null, "band": [0.18, 0.22]},
    {"over": 4, "value": null, "low": 0.5, "high": null, "band": [0.4, null]}]}]})");

TEST(PhaseDiagramPicture, DrawsABoundaryWithItsBandUpToTheEndOfTheRange) {
  const std::string script = phase_diagram_script(small_diagram(), kBoundary, {}, {"fig.svg"});
  EXPECT_THAT(script, HasSubstr("$band_1 << END\n0.18 2\n0.4 4\n1 4\n0.22 2\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$boundary_1 << END\n0.2 2 0.19 1\nEND\n"));
}

TEST(PhaseDiagramPicture, DrawsABoundaryOfOneRowAsAPointWithItsBarAndBand) {
  PhaseDiagram row = small_diagram();
  row.y.values = {2};
  row.rows.pop_back();
  nlohmann::ordered_json boundary = kBoundary;
  boundary["curves"][0]["points"].erase(1);
  const std::string with_parameter = phase_diagram_script(row, boundary, {}, {"fig.svg"});
  EXPECT_THAT(with_parameter, HasSubstr("$band_1 << END\n0.18 2\n0.22 2\nEND\n"));
  EXPECT_THAT(with_parameter, HasSubstr("plot $band_1 with lines"));
  EXPECT_THAT(with_parameter, HasSubstr("$boundary_1 using 1:2 with points"));
  row.y = {"", {nullptr}};
  boundary["curves"][0]["over"] = boundary["curves"][0]["points"][0]["over"] = nullptr;
  EXPECT_THAT(phase_diagram_script(row, boundary, {}, {"fig.svg"}),
              HasSubstr("$boundary_1 << END\n0.2 0 0.19 1\nEND\n"));
}

TEST(PhaseDiagramPicture, DrawsNoBoundaryOverOtherAxes) {
  PhaseDiagram other = small_diagram();
  other.y.parameter = "E_b";
  EXPECT_THAT(phase_diagram_script(other, kBoundary, {}, {"fig.svg"}), Not(HasSubstr("$band")));
}

TEST(PhaseDiagramPicture, ShowsThePublishedBoundaryWithItsSource) {
  const std::string script = phase_diagram_script(small_diagram(), nullptr,
                                                  {{"Smith (2020)", {{{0.3, 2}}, {{0.4, 4}}}}}, {"fig.svg"});
  EXPECT_THAT(script, HasSubstr("$published_1 << END\n0.3 2\n0.4 4\nEND"));
  EXPECT_THAT(script, HasSubstr("title 'Smith (2020)'"));
}

TEST(HistoryPicture, HasACurveOfEachCaseWithThetaInUnitsOfPi) {
  const std::string script = history_script({{"Ca = 0.1", turning(2)}, {"it's", turning(1)}}, {}, {"h.pdf"});
  EXPECT_THAT(script, HasSubstr("$case1 << END\n0 0.3 0\n0.5 0.3 -0.25\n"));
  EXPECT_THAT(script, HasSubstr("$case2 using 1:($3/pi) with lines"));
  EXPECT_THAT(script, HasSubstr("title 'it''s' noenhanced"));
}

TEST(HistoryPicture, HasPublishedPointsAsMarksOverTheCurves) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::string script = history_script(
      {{"Ca = 0.1", turning(2)}}, {{"A 1998", {{0.5, 0.29, none}}}, {"B", {{1, 0.3, 0.2}}}}, {"h.pdf"});
  EXPECT_THAT(script, HasSubstr("$published1 << END\n0.5 0.29 NaN\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$published1 using 1:2 with points"));
  EXPECT_THAT(script, Not(HasSubstr("$published1 using 1:3")));
  EXPECT_THAT(script, HasSubstr("$published2 using 1:3 with points"));
  EXPECT_THAT(script, HasSubstr("title 'A 1998' noenhanced"));
}

TEST(HistoryPicture, EndsWithTheLongestRun) {
  EXPECT_THAT(history_script({{"a", turning(2)}, {"b", turning(1)}}, {{"A", {{7, 0.3, 0}}}}, {"h.pdf"}),
              HasSubstr("set xrange [0:2]"));
}

const std::vector<ClosedCurve> kTriangle = {{{1, 0}, {0, 1}, {-1, 0}}};

TEST(ProfilePicture, HasAPanelForEachTimeWithClosedSectionsAndTheirMarkers) {
  const std::string script = profile_script(
      {{"kt = 5", {{"a", kTriangle, {1, 0}}}}, {"kt = 8", {{"a", kTriangle, {0, 1}}}}}, {"p.svg"});
  EXPECT_THAT(script, HasSubstr("set multiplot layout 1,2 margins"));
  EXPECT_THAT(script, HasSubstr("$panel1_1 << END\n1 0\n0 1\n-1 0\n1 0\n\nEND\n"));
  EXPECT_THAT(script, HasSubstr("$panel2_1_marker << END\n0 1\nEND\n"));
  EXPECT_THAT(script, HasSubstr("set title 'kt = 8'"));
}

TEST(ProfilePicture, HasThreePanelsInARow) {
  const ProfilePanel panel{"", {{"a", kTriangle, {1, 0}}}};
  EXPECT_THAT(profile_script({panel, panel, panel, panel}, {"p.svg"}),
              HasSubstr("set multiplot layout 2,3 margins"));
}

TEST(TrajectoryPicture, HasAnArrowOfTheVelocityAtEachPoint) {
  const std::string script =
      trajectory_script({{"a", {{{1, 0}, {0, -0.5}}, {{0.9, -0.3}, {-0.3, -0.5}}}}}, {"t.svg"});
  EXPECT_THAT(script, HasSubstr("$case1 << END\n1 0 0 -0.5\n0.9 -0.3 -0.3 -0.5\nEND\n"));
  EXPECT_THAT(script, HasSubstr("with vectors"));
}

TEST(Picture, FileMustHaveAnExtensionOfAPicture) {
  EXPECT_EQ(issue_of_picture_file("b.pdf"), "");
  EXPECT_THAT(issue_of_picture_file("b.jpg"), HasSubstr("must end in .svg, .pdf or .png"));
}

TEST(Picture, IsDrawnInEachFormatAndKeepsItsScript) {
  const TemporaryDirectory directory;
  for (const auto& [name, start] : std::vector<std::pair<std::string, std::string>>{
           {"p.svg", "<?xml"}, {"p.pdf", "%PDF"}, {"p.png", "\x89PNG"}}) {
    const PictureFormat format{directory.path() / name};
    draw(phase_diagram_script(small_diagram(), kBoundary, {}, format), format);
    EXPECT_THAT(file_bytes(format.file), StartsWith(start));
    EXPECT_THAT(file_bytes(format.file.string() + ".gp"), HasSubstr("plot $band_1"));
    draw(history_script({{"a", turning(3)}}, {}, format), format);
    draw(path_script({{"a", turning(3)}}, format), format);
    draw(profile_script({{"kt = 1", {{"a", kTriangle, {1, 0}}}}}, format), format);
    draw(trajectory_script({{"a", {{{1, 0}, {0, -0.5}}}}}, format), format);
  }
}

TEST(Picture, OfAWrongScriptIsAnErrorThatNamesTheScript) {
  const TemporaryDirectory directory;
  const PictureFormat format{directory.path() / "p.svg"};
  EXPECT_THROW(draw("plot nothing of this name\n", format), std::runtime_error);
}

}  // namespace
}  // namespace capstan
