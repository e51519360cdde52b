#pragma once
// What the exit status of `capstan` means (schema/exit_codes.md).

namespace capstan {

inline constexpr int kExitDone = 0;
inline constexpr int kExitError = 1;         ///< the environment: a full disk, a port that is taken
inline constexpr int kExitInvalidInput = 2;  ///< all faults are on standard error
inline constexpr int kExitNoAnswer =
    3;  ///< a numerical failure; of a study: some cases ended without an answer
inline constexpr int kExitNotFound = 4;      ///< the server knows no such study
inline constexpr int kExitUnreachable = 69;  ///< no server answers (EX_UNAVAILABLE)
inline constexpr int kExitInterrupted = 75;  ///< a checkpoint is written, start again to resume (EX_TEMPFAIL)

}  // namespace capstan
