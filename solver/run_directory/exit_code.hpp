#pragma once
// Exit codes of `capstan` (schema/exit_codes.md).

namespace capstan {

inline constexpr int kExitDone = 0;
inline constexpr int kExitError = 1;         ///< an error of the environment: a full disk, a port in use
inline constexpr int kExitInvalidInput = 2;  ///< standard error lists all issues
inline constexpr int kExitNoAnswer = 3;      ///< a numerical failure; for a study: some cases have no result
inline constexpr int kExitNotFound = 4;      ///< the server has no such study
inline constexpr int kExitUnreachable = 69;  ///< no server answers (EX_UNAVAILABLE)
inline constexpr int kExitInterrupted =
    75;  ///< a checkpoint was written: start again to resume (EX_TEMPFAIL)

}  // namespace capstan
