# The headers of other libraries that most files include, compiled once for each set of flags. Clang only: the clang build
# takes two thirds of the time with them, while g++ 12 gains little and warns of overflows in std::string's operator+
# where there are none. A file still includes what it uses: the builds with g++ and clang-tidy read the headers themselves.
set(CAPSTAN_PRECOMPILED_HEADERS
  <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <optional> <sstream> <string> <variant>
  <vector> <Eigen/Dense> <nlohmann/json.hpp>)
set(CAPSTAN_PRECOMPILED_TEST_HEADERS ${CAPSTAN_PRECOMPILED_HEADERS} <gmock/gmock.h> <gtest/gtest.h>)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
