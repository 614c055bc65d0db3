// Standard output and standard error whose failed writes never end the program.
#pragma once

#include <string_view>

namespace cls::base {

enum class StandardStream { kOutput, kError };

/// Opens /dev/null for closed standard descriptors, so that no later file gets their numbers; a
/// write to them fails as before. Call it before the initializers of libraries, which open files.
void open_standard_descriptors();

/// Replaces `stdout` and `stderr` by streams that accept everything: bytes that cannot be written
/// (a full disk, a closed descriptor, a pipe without a reader) are dropped, and the first cause is
/// stored for write_error(). Call once, first in main.
void protect_standard_streams();

/// True if open_standard_descriptors() found standard input closed.
bool input_was_closed();

/// errno of the first failed write to the stream; 0: none failed.
int write_error(StandardStream stream);

/// Writes to a duplicate of a standard stream's descriptor, with the same care.
void write_to_duplicate(int descriptor, StandardStream stream, std::string_view bytes);

}  // namespace cls::base
