#include "runner/slurm/case_list.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <sstream>
#include <system_error>

#include "solver/run_directory/durable_file.hpp"

namespace capstan {
namespace {

constexpr const char* kBegan = "began";
constexpr const char* kExited = "exited";
constexpr const char* kSignalled = "signalled";

/// With one write, so that no reader sees half of a line, and synced, so that the daemon on another machine
/// sees it.
void append_line(const std::filesystem::path& file, const std::string& line) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  const bool is_written = descriptor >= 0 &&
                          write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size()) &&
                          fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) close(descriptor);
  if (!is_written) throw std::system_error(error, std::generic_category(), "cannot write " + file.string());
}

void read_line(const std::string& line, std::map<std::string, NotedRun>& runs) {
  std::istringstream words(line);
  std::string token, event;
  int number = 0;
  words >> token >> event;
  if (event == kBegan) runs[token].has_begun = true;
  if (!(words >> number)) return;
  if (event == kExited) runs[token].end = ProcessEnd{ProcessEnd::How::exited, number};
  if (event == kSignalled) runs[token].end = ProcessEnd{ProcessEnd::How::signalled, number};
}

}  // namespace

void write_case_list(const std::filesystem::path& file, const std::vector<ListedCase>& cases) {
  std::string text;
  for (const ListedCase& listed : cases)
    text += listed.token + " " + listed.case_id + " " + listed.directory.path().string() + "\n";
  write_durably(file, text);
}

std::vector<ListedCase> read_case_list(const std::filesystem::path& file) {
  std::vector<ListedCase> cases;
  std::istringstream lines(read_file(file).value_or(""));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    cases.push_back({line.substr(0, first), line.substr(first + 1, second - first - 1),
                     RunDirectory(line.substr(second + 1))});
  }
  return cases;
}

void note_beginning(const std::filesystem::path& journal, const std::string& token) {
  append_line(journal, token + " " + kBegan + "\n");
}

void note_end(const std::filesystem::path& journal, const std::string& token, const ProcessEnd& end) {
  const char* how = end.how == ProcessEnd::How::exited ? kExited : kSignalled;
  append_line(journal, token + " " + how + " " + std::to_string(end.number) + "\n");
}

std::map<std::string, NotedRun> read_journal(const std::filesystem::path& file) {
  std::map<std::string, NotedRun> runs;
  const std::string text = read_file(file).value_or("");
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  for (std::string line; std::getline(lines, line);) read_line(line, runs);
  return runs;
}

}  // namespace capstan
