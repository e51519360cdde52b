# insert_before(CONTENT LINE TEXT): inserts TEXT before the first occurrence of LINE in the variable CONTENT.
function(insert_before content line text)
  string(FIND "${${content}}" "${line}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "No line \"${line}\" to insert before")
  endif()
  string(SUBSTRING "${${content}}" 0 ${place} before)
  string(SUBSTRING "${${content}}" ${place} -1 after)
  set(${content} "${before}${text}${after}" PARENT_SCOPE)
endfunction()

# The observable "largest principal stretch" changes two files: the table and its functions.
set(table solver/observe/observables.hpp)
set(functions solver/observe/measure.cpp)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/${table} ${PROJECT_SOURCE_DIR}/${functions})

file(READ ${PROJECT_SOURCE_DIR}/${table} table_text)
insert_before(table_text "};\ninline constexpr std::size_t kObservableCount"
  [[    {.name = "lambda_max", .unit = "1", .description = "largest principal stretch of the membrane"},
]])

file(READ ${PROJECT_SOURCE_DIR}/${functions} functions_text)
insert_before(functions_text "#include \"solver/mesh/geometry.hpp\"" [[#include "solver/membrane/in_plane.hpp"
]])
insert_before(functions_text "template <std::size_t... row>" [[template <>
double measure<"lambda_max">(const Snapshot& now) {
  const Case& c = now.parameters;
  const InPlaneElasticity membrane(now.mesh.faces, now.reference, *c.law, c.law_constants, 1);
  return membrane.stretches(now.positions).col(0).maxCoeff();
}

]])

set(changed ${CMAKE_CURRENT_BINARY_DIR}/new_observable)
file(CONFIGURE OUTPUT ${changed}/${table} CONTENT "${table_text}" @ONLY)
file(CONFIGURE OUTPUT ${changed}/${functions} CONTENT "${functions_text}" @ONLY)

# All sources that use the table are compiled again. Their include path finds the changed table first.
capstan_test(new_observable_test LABEL unit LINKS capstan::runner capstan::solver SOURCES
  unit/observe/new_observable_test.cpp
  ${changed}/${functions}
  ${PROJECT_SOURCE_DIR}/runner/queries/history_query.cpp
  ${PROJECT_SOURCE_DIR}/runner/queries/time_grid.cpp
  ${PROJECT_SOURCE_DIR}/runner/recording/history.cpp
  ${PROJECT_SOURCE_DIR}/runner/render/result_columns.cpp
  ${PROJECT_SOURCE_DIR}/runner/store/history_columns.cpp
  ${PROJECT_SOURCE_DIR}/runner/web/openapi_text.cpp
  ${PROJECT_SOURCE_DIR}/solver/run_directory/history_line.cpp)
target_include_directories(new_observable_test BEFORE PRIVATE ${changed})
