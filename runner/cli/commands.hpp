#pragma once
// The commands, with their arguments read. Each returns the exit code.
#include <string>
#include <thread>

#include "runner/cli/client.hpp"

namespace capstan {

struct ServeArguments {
  std::string data = "capstan-data";
  std::string listen = "127.0.0.1:8017";
  int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
};
int serve(const ServeArguments& arguments);

int validate_study(const std::string& file);

struct SubmitArguments {
  std::string file;
  bool watch = false;
  std::string server = kDefaultServer;
};
int submit_study(const SubmitArguments& arguments);

int print_studies(const std::string& server);

struct StudyArguments {
  std::string id;
  std::string format = "table";  ///< of print_results: table, csv, json
  std::string server = kDefaultServer;
};
int print_study(const StudyArguments& arguments);
int watch_study(const StudyArguments& arguments);
int print_results(const StudyArguments& arguments);
int print_phase_diagram(const StudyArguments& arguments);
int cancel_study(const StudyArguments& arguments);

}  // namespace capstan
