#pragma once
// The cases that one task of a job array computes, and what it notes about them. Both are text files, which
// the daemon and the job share; a job never opens the database.
//
//   list     TOKEN CASE_ID DIRECTORY     one line a case, in the order of their computation
//   journal  TOKEN began                 appended by the job
//            TOKEN exited 0
//            TOKEN signalled 9
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/recording/process_end.hpp"
#include "solver/run_directory/run_directory.hpp"

namespace capstan {

struct ListedCase {
  std::string token;  ///< of the attempt
  std::string case_id;
  RunDirectory directory;
};

/// Durably: the list must be there before its job is submitted.
void write_case_list(const std::filesystem::path& file, const std::vector<ListedCase>& cases);
/// Lines of another form are left out. Throws std::filesystem::filesystem_error if the file cannot be read.
std::vector<ListedCase> read_case_list(const std::filesystem::path& file);

/// Appends to the journal of a task.
void note_beginning(const std::filesystem::path& journal, const std::string& token);
void note_end(const std::filesystem::path& journal, const std::string& token, const ProcessEnd& end);

/// What a journal says of one case.
struct NotedRun {
  bool has_begun = false;
  std::optional<ProcessEnd> end;
};

/// By token. Empty if there is no journal yet; a line that is not complete is left out.
std::map<std::string, NotedRun> read_journal(const std::filesystem::path& file);

}  // namespace capstan
