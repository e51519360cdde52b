#include "runner/cli/program.hpp"
#include "runner/execute/compare.hpp"
#include "runner/execute/worker.hpp"

int main(int argc, char** argv) { return capstan::run_program(argc, argv, {capstan::solve_case, capstan::compare_models}); }
