#pragma once
// Where runs are, as answers show it. The executor knows it (runner/daemon/executor.hpp).
#include <cstddef>
#include <functional>
#include <string>

namespace capstan {

/// Where one run is.
struct RunPlace {
  bool is_waiting = false;  ///< in the queue of a cluster; false: it computes
  std::string kind;         ///< the same for all runs that wait for one reason or compute in one place
  std::string details;      ///< with the number of the job or process
};

/// Where all runs are.
struct RunPlaces {
  std::size_t slots = 0;  ///< number of cases that compute at the same time, at most
  std::string slot_name;  ///< what the slots are: "cores"
  std::string obstacle;   ///< why no case is started, as a sentence; or ""
  std::function<RunPlace(const std::string& handle)> place_of;
};

}  // namespace capstan
