// Writes case.schema.json and study.schema.json into a folder, for editors and validators. The build runs it,
// the HTTP API serves the same documents.
#include <fstream>
#include <iostream>
#include <string>

#include "runner/study/study_schema.hpp"
#include "solver/case/json_schema.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_schemas FOLDER\n";
    return 1;
  }
  const std::string folder = argv[1];
  std::ofstream case_file(folder + "/case.schema.json"), study_file(folder + "/study.schema.json");
  case_file << capstan::case_schema().dump(2) << '\n';
  study_file << capstan::study_schema().dump(2) << '\n';
  case_file.close(), study_file.close();
  return case_file && study_file ? 0 : 1;
}
