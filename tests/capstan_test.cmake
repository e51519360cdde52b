# capstan_test_program(NAME [RUNS PROGRAM] LINKS LIBRARY... SOURCES FILE...)
#   Adds a program of the tests. If it runs the target PROGRAM as a process, CAPSTAN_PROGRAM is the path of that.
function(capstan_test_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "RUNS" "LINKS;SOURCES")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} source_directory GTest::gmock capstan_warnings)
  if(arg_RUNS)
    target_compile_definitions(${name} PRIVATE CAPSTAN_PROGRAM="$<TARGET_FILE:${arg_RUNS}>")
    add_dependencies(${name} ${arg_RUNS})
  endif()
endfunction()

# All programs of tests with the label "unit": cmake --build --preset test --target unit_tests
add_custom_target(unit_tests)

# capstan_test(NAME LABEL LABEL [PREFIX PREFIX] [RUNS PROGRAM] LINKS LIBRARY... SOURCES FILE...)
#   Adds a program with GoogleTest's main, and each of its tests to CTest, with the label and the prefix before its
#   name.
function(capstan_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;PREFIX" "")
  capstan_test_program(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE GTest::gmock_main)
  if("${ARGN}" MATCHES "capstan::(solver|baseline)")
    target_precompile_headers(${name} REUSE_FROM test_headers_openmp)
  else()
    target_precompile_headers(${name} REUSE_FROM test_headers)
  endif()
  if(arg_LABEL STREQUAL "unit")
    add_dependencies(unit_tests ${name})
  endif()
  # CTest begins with the highest cost: with the longest tests, so that no core is idle at the end.
  set(from_short_to_long unit system physics slow)
  list(FIND from_short_to_long ${arg_LABEL} cost)
  # NO_PRETTY_VALUES: the names of value-parameterised tests are those given in the sources.
  gtest_discover_tests(${name} TEST_PREFIX "${arg_PREFIX}" NO_PRETTY_VALUES PROPERTIES LABELS ${arg_LABEL} COST ${cost}
    ENVIRONMENT LSAN_OPTIONS=suppressions=${CMAKE_CURRENT_SOURCE_DIR}/support/lsan_suppressions.txt)
endfunction()
