// The order of the folders, checked in the sources themselves: includes point downwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/source_directory.hpp"

namespace {

namespace fs = std::filesystem;

/// From the bottom up. A folder may include itself and those before it: so there are no cycles.
const std::vector<std::string> kOrder = {
    "solver/grid",       "solver/strain_laws", "solver/case",          "solver/state",    "solver/mesh",
    "solver/membrane",   "solver/observe",     "solver/run_directory", "solver/coupling", "solver/fluid",
    "solver/simulation", "solver/output",      "solver/baseline",      "runner/boundary", "runner/study",
    "runner/store",      "runner/queue",       "runner/recording",     "runner/queries",  "runner/render",
    "runner/daemon",     "runner/slurm",       "runner/doctor",        "runner/web",      "runner/worker",
    "runner/cli"};

/// Place in the order; nothing for a folder that has none.
std::optional<std::size_t> place_of(const std::string& folder) {
  const auto found = std::find(kOrder.begin(), kOrder.end(), folder);
  if (found == kOrder.end()) return std::nullopt;
  return found - kOrder.begin();
}

struct Include {
  std::string from;  ///< path of the including file
  std::string to;    ///< path that is included
};

/// "solver/fluid/paper/level.hpp" stands in the folder solver/fluid.
std::string folder_of(const std::string& path) { return path.substr(0, path.find('/', path.find('/') + 1)); }

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
    const fs::path root = capstan::source_directory();
    std::vector<Include> found;
    for (const char* part : {"solver", "runner"})
      for (const auto& entry : fs::recursive_directory_iterator(root / part))
        if (is_source(entry.path()))
          for (Include& include : includes_of(root, entry.path())) found.push_back(std::move(include));
    return found;
  }();
  return all;
}

TEST(Includes, AreFoundAtAll) { EXPECT_GT(all_includes().size(), 50u); }

TEST(Includes, NameTheirFileFromTheTopOfTheTree) {
  for (const auto& [from, to] : all_includes())
    EXPECT_TRUE(fs::exists(capstan::source_directory() / to)) << from << " includes " << to;
}

TEST(Includes, PointDownwards) {
  for (const auto& [from, to] : all_includes()) {
    const auto above = place_of(folder_of(from)), below = place_of(folder_of(to));
    ASSERT_TRUE(above.has_value()) << folder_of(from) << " has no place in the order";
    ASSERT_TRUE(below.has_value()) << folder_of(to) << " has no place in the order";
    EXPECT_GE(*above, *below) << from << " includes " << to;
  }
}

// Flow models take options. Only solver/simulation knows the case, and makes the options from it.
TEST(Includes, NoGridCouplingOrFlowModelKnowsTheCase) {
  for (const auto& [from, to] : all_includes())
    for (const char* folder : {"solver/grid", "solver/coupling", "solver/fluid"})
      EXPECT_FALSE(folder_of(from) == folder && folder_of(to) == "solver/case") << from << " includes " << to;
}

/// The folder of a flow model, e.g. "solver/fluid/paper"; empty for other files.
std::string model_of(const std::string& path) {
  const std::string fluid = "solver/fluid/";
  const auto end = path.find('/', fluid.size());
  return path.starts_with(fluid) && end != std::string::npos ? path.substr(0, end) : "";
}

TEST(Includes, FlowModelsKnowNoOtherModelButTheSharedLatticeBoltzmannCode) {
  for (const auto& [from, to] : all_includes()) {
    if (model_of(from).empty() || model_of(to).empty()) continue;
    EXPECT_TRUE(model_of(to) == model_of(from) || model_of(to) == "solver/fluid/lbm")
        << from << " includes " << to;
  }
}

// Other parts of the solver could not be linked: only runner/worker is linked with the whole solver.
TEST(Includes, OnlyTheWorkerKnowsMoreOfTheSolverThanTheCaseAndTheRunDirectory) {
  for (const auto& [from, to] : all_includes()) {
    if (!from.starts_with("runner/") || !to.starts_with("solver/") || folder_of(from) == "runner/worker")
      continue;
    EXPECT_TRUE(folder_of(to) == "solver/case" || folder_of(to) == "solver/run_directory")
        << from << " includes " << to;
  }
}

}  // namespace
