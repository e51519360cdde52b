// The order of the modules, checked in the sources themselves: includes point downwards or to a neighbour.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// From the bottom up. A module may include its own level and those below.
const std::map<std::string, int> kLevels = {
    {"solver/case", 0},     {"solver/state", 0},                                                      //
    {"solver/mesh", 1},                                                                               //
    {"solver/coupling", 2}, {"solver/fluid", 2},      {"solver/membrane", 2}, {"solver/observe", 2},  //
    {"solver/baseline", 3}, {"solver/simulation", 3},                                                 //
    {"runner/study", 4},    {"runner/queue", 4},      {"runner/execute", 4},  {"runner/results", 4},  //
    {"runner/bench", 4},                                                                              //
    {"runner/service", 5},                                                                            //
    {"runner/cli", 6},      {"runner/web", 6},
};

struct Include {
  std::string from;  ///< path of the including file
  std::string to;    ///< path that is included
};

/// "solver/fluid/paper/level.hpp" belongs to the module solver/fluid.
std::string module_of(const std::string& path) { return path.substr(0, path.find('/', path.find('/') + 1)); }

bool is_source(const fs::path& path) { return path.extension() == ".cpp" || path.extension() == ".hpp"; }

std::vector<Include> includes_of(const fs::path& root, const fs::path& file) {
  static const std::regex directive(R"(^\s*#\s*include\s*"([^"]+)\")");
  std::vector<Include> includes;
  std::ifstream stream(file);
  std::smatch match;
  for (std::string line; std::getline(stream, line);)
    if (std::regex_search(line, match, directive)) includes.push_back({fs::relative(file, root), match[1]});
  return includes;
}

/// Every include of a file of ours by a file of ours.
const std::vector<Include>& all_includes() {
  static const std::vector<Include> all = [] {
    const fs::path root = CAPSTAN_SOURCE_DIR;
    std::vector<Include> found;
    for (const char* part : {"solver", "runner"})
      for (const auto& entry : fs::recursive_directory_iterator(root / part))
        if (is_source(entry.path()))
          for (Include& include : includes_of(root, entry.path())) found.push_back(std::move(include));
    return found;
  }();
  return all;
}

/// What `capstan bench` measures is the solver itself, any part of it.
bool measures_the_solver(const std::string& path) { return path.starts_with("runner/bench/"); }

bool may_run_the_solver(const std::string& path) {
  return path.starts_with("runner/worker/solve") || path.starts_with("runner/worker/compare");
}

TEST(Includes, AreFoundAtAll) { EXPECT_GT(all_includes().size(), 50u); }

TEST(Includes, NameTheirFileFromTheTopOfTheTree) {
  for (const auto& [from, to] : all_includes())
    EXPECT_TRUE(fs::exists(fs::path(CAPSTAN_SOURCE_DIR) / to)) << from << " includes " << to;
}

TEST(Includes, PointDownwardsOrToANeighbour) {
  for (const auto& [from, to] : all_includes()) {
    ASSERT_TRUE(kLevels.contains(module_of(from)))
        << from << " belongs to no module with a place in the order";
    ASSERT_TRUE(kLevels.contains(module_of(to))) << to << " belongs to no module with a place in the order";
    EXPECT_GE(kLevels.at(module_of(from)), kLevels.at(module_of(to))) << from << " includes " << to;
  }
}

TEST(Includes, TheStateAndTheCaseNeedNothingElseOfTheSolver) {
  for (const auto& [from, to] : all_includes()) {
    if (module_of(from) != "solver/state" && module_of(from) != "solver/case") continue;
    EXPECT_EQ(module_of(to), module_of(from)) << from << " includes " << to;
  }
}

TEST(Includes, OnlyTheWorkerTheComparisonAndTheBenchmarksKnowMoreOfTheSolverThanTheCaseAndItsFiles) {
  for (const auto& [from, to] : all_includes()) {
    if (!from.starts_with("runner/") || !to.starts_with("solver/")) continue;
    const std::string module = module_of(to);
    const bool allowed = module == "solver/case" || module == "solver/state" || measures_the_solver(from) ||
                         (module == "solver/simulation" && may_run_the_solver(from));
    EXPECT_TRUE(allowed) << from << " includes " << to;
  }
}

}  // namespace
