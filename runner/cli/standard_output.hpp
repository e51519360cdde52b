#pragma once
// Standard streams that are closed, full or broken.

namespace capstan {

/// Opens /dev/null in place of each standard stream that the caller has closed: standard input for writing
/// only, the outputs for reading only, so that every read or write fails. Otherwise the next file that the
/// program opens would take the descriptor and receive its output.
void occupy_closed_streams();

/// Flushes standard output. Returns false if something that was printed is lost. Prints the reason to
/// standard error, unless the reader of a pipe has closed it (`| head`).
bool flush_standard_output();

}  // namespace capstan
