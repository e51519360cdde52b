#pragma once
// Files of schema/ that the server returns, embedded by the build.

namespace capstan {

extern const char* const kOpenApi;      ///< openapi.yaml
extern const char* const kStudySchema;  ///< study.schema.json, to which openapi.yaml refers
extern const char* const kCaseSchema;   ///< case.schema.json, likewise

}  // namespace capstan
