#pragma once
// Whether what a command printed has arrived.

namespace capstan {

/// Gives the standard streams that the caller has closed a place that can neither be read nor written, so
/// that no file of the program takes it.
void occupy_closed_streams();

/// Writes out what is still held. False if something that was printed is lost: standard error says so, unless
/// a reader went away that had enough (`| head`).
bool output_has_arrived();

}  // namespace capstan
