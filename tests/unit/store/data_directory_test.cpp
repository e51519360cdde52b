#include "runner/store/data_directory.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

TEST(NetworkFileSystem, IsKnownByItsNumber) {
  EXPECT_EQ(network_file_system(0x6969), "NFS");
  EXPECT_EQ(network_file_system(static_cast<int>(0xFF534D42)), "CIFS");
  EXPECT_EQ(network_file_system(0xEF53), "");  // ext4
}

TEST(DataDirectory, IsRefusedToASecondDaemon) {
  const TemporaryDirectory directory;
  const DataDirectory data(directory.path());
  EXPECT_THROW(DataDirectory{directory.path()}, std::runtime_error);
}

}  // namespace
}  // namespace capstan
