#include "runner/cli/program.hpp"

int main(int argc, char** argv) { return capstan::run_program(argc, argv, nullptr); }
