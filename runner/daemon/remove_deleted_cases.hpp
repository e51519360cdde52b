#pragma once
// Removing the cases of deleted studies, a few at a time.
#include "runner/store/data_directory.hpp"
#include "runner/store/database.hpp"

namespace capstan {

/// Removes the rows of some cases that no study wants any more, then their run directories. A directory that
/// cannot be removed is tried again at the next call. The caller holds the writer's mutex.
void remove_deleted_cases(Database& database, const DataDirectory& data);

}  // namespace capstan
