#pragma once
// Bringing an older database to the present format.

namespace capstan {

class Database;

/// Makes the tables of a new database, or runs the steps that an older one lacks, in one transaction. The
/// format of a database is its user_version. Throws DatabaseError for a format that is newer than this
/// program.
void upgrade_to_present_format(Database& database);

}  // namespace capstan
