# Writes the git revision of SOURCES into the source file FILE. Leaves the file untouched if it has that revision, so
# that it is not compiled again.
execute_process(COMMAND git -C ${SOURCES} describe --always --dirty --abbrev=12 --match=
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(text "#include \"runner/cli/revision.hpp\"\n\nconst char* const capstan::kRevision = \"${revision}\";\n")
set(old_text "")
if(EXISTS ${FILE})
  file(READ ${FILE} old_text)
endif()
if(NOT text STREQUAL old_text)
  file(WRITE ${FILE} "${text}")
endif()
