# Writes FILE, which names the revision of SOURCES, unless it says so already.
execute_process(COMMAND git -C ${SOURCES} describe --always --dirty --abbrev=12 --match=
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(text "#include \"runner/cli/revision.hpp\"\n\nconst char* const capstan::kRevision = \"${revision}\";\n")
set(there "")
if(EXISTS ${FILE})
  file(READ ${FILE} there)
endif()
if(NOT text STREQUAL there)
  file(WRITE ${FILE} "${text}")
endif()
