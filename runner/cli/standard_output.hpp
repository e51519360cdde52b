#pragma once
// Standard streams that are closed, full or broken.

namespace capstan {

/// Opens /dev/null in place of standard streams that the caller has closed, in the direction that makes every
/// read or write fail. Otherwise the next file that the program opens would take the descriptor and receive
/// its output.
void occupy_closed_streams();

/// Flushes standard output. Returns false if something that was printed is lost. Prints the reason to
/// standard error, unless the reader of a pipe has closed it (`| head`).
bool flush_standard_output();

}  // namespace capstan
