#include "runner/cli/progress.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace capstan {
namespace {

using nlohmann::ordered_json;

ordered_json study(int done, int running, int queued, double progress) {
  return {{"progress", progress},
          {"cases",
           {{"total", done + running + queued},
            {"queued", queued},
            {"running", running},
            {"done", done},
            {"failed", 0},
            {"diverged", 0},
            {"cancelled", 0}}}};
}

TEST(Progress, TextCountsTheCasesThatHaveEnded) {
  EXPECT_EQ(progress_text(study(2, 1, 1, 0.5)),
            "[###############...............]  50 %  2 of 4 cases, 1 running");
}

TEST(Progress, TextSaysHowManyPointsASearchWillProbablyAskFor) {
  ordered_json searching = study(2, 1, 1, 0.5);
  searching["expected_points"] = 7;
  EXPECT_EQ(progress_text(searching),
            "[###############...............]  50 %  2 of 4 cases, 1 running, about 7 more expected");
}

TEST(Progress, LogHasOneLineForEachChangeAndNoEscapeCodes) {
  std::ostringstream out;
  ProgressLine line(out, false);
  for (double progress : {0.1, 0.11, 0.12}) line.show(study(0, 2, 2, progress));
  line.show(study(1, 2, 1, 0.3));
  line.finish();
  EXPECT_EQ(out.str(),
            "[###...........................]  10 %  0 of 4 cases, 2 running\n"
            "[#########.....................]  30 %  1 of 4 cases, 2 running\n");
}

TEST(Progress, LineOnATerminalIsRewritten) {
  std::ostringstream out;
  ProgressLine line(out, true);
  line.show(study(0, 2, 2, 0.1));
  line.show(study(0, 2, 2, 0.2));
  EXPECT_EQ(out.str().find('\n'), std::string::npos);
  EXPECT_NE(out.str().rfind("\r\x1b[K"), 0u);
}

TEST(Progress, DurationsAreReadable) {
  EXPECT_EQ(duration_text(std::chrono::seconds(45)), "45 s");
  EXPECT_EQ(duration_text(std::chrono::minutes(12)), "12 min");
  EXPECT_EQ(duration_text(std::chrono::minutes(200)), "3 h 20 min");
}

}  // namespace
}  // namespace capstan
