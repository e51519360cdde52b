// Runs a fuzz target on every file of the given directories: inputs that once caused an error, or that
// reached much of the code.
#include <cstdint>
#include <filesystem>
#include <iostream>

#include "tests/support/file_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  int count = 0;
  for (int i = 1; i < argc; ++i)
    for (const auto& file : std::filesystem::directory_iterator(argv[i])) {
      const std::string bytes = capstan::file_bytes(file.path());
      std::cout << file.path().filename() << std::endl;
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++count;
    }
  std::cout << count << " inputs\n";
  return count > 0 ? 0 : 1;
}
