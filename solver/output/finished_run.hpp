#pragma once
// A run that has ended, as its files tell it.
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/case/case.hpp"
#include "solver/observe/observables.hpp"
#include "solver/run_directory/run_directory.hpp"
#include "solver/run_directory/stop.hpp"

namespace capstan {

struct FinishedRun {
  Case parameters;
  History history;
  nlohmann::ordered_json result;  ///< result.json

  Stop stop() const;
  bool is_answered() const { return has_answer(stop()); }
};

/// The run of this case in a directory; nothing if there is none that has ended, or it belongs to another
/// case or another numerics version.
std::optional<FinishedRun> finished_run(const RunDirectory& directory, const Case& c);

}  // namespace capstan
