#pragma once
// Records the results of an exported study (export_cases.hpp) in a data directory.
#include <filesystem>

#include "runner/daemon/queue_writer.hpp"
#include "runner/store/data_directory.hpp"
#include "runner/study/study.hpp"

namespace capstan {

struct Collection {
  std::string study_id;
  int recorded = 0;    ///< results that are new
  int known = 0;       ///< cases whose result was there already
  int unfinished = 0;  ///< cases without a result
};

/// Submits the study if it is not known, copies the run directories that have a result into the data
/// directory, and records them. Each result is recorded once, however often this is called.
/// \param directory  the exported directory
Collection collect(const Study& study, const std::filesystem::path& directory, const DataDirectory& data,
                   QueueWriter& writer, const Clock& clock);

}  // namespace capstan
