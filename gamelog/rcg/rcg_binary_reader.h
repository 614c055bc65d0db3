// Reading game logs of versions 1, 2 and 3.
#pragma once

#include "base/io/input_buffer.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {

/// True if `start`, the first bytes of a file, can be those of a version 1 log, which has no
/// header.
bool looks_like_version_1(std::string_view start);

/// Reads everything behind the header (log-formats 1.4 to 1.6); the version is the record's. What
/// a version does not know is zero in the record: velocities, stamina, view and counters before
/// version 3. Records of unknown kinds end the reading: nobody knows how long they are.
void read_rcg_binary(base::InputBuffer& input, RecordBuilder& builder);

}  // namespace cls::gamelog
