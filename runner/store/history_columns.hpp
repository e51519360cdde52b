#pragma once
// The columns of the table `histories`: one for each observable that the database keeps.
#include <string>
#include <vector>

#include "runner/store/database.hpp"

namespace capstan {

/// Names of the observables that the database keeps, in the order of kObservables.
const std::vector<std::string>& history_columns();

/// The same for a SELECT: "kt, D_xy, ..", with NULL for a column that this database lacks. Columns are
/// missing until a writer of this version of the program has opened the database.
std::string history_columns_in(Database& database);

/// Adds the columns that the database lacks. They are NULL in the records that exist already.
void add_history_columns(Database& database);

}  // namespace capstan
