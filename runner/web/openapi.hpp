#pragma once

namespace capstan {

/// The text of schema/openapi.yaml, and of the schemas beside it that it refers to.
extern const char* const kOpenApi;
extern const char* const kStudySchema;
extern const char* const kCaseSchema;

}  // namespace capstan
