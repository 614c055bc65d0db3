// Readers of the game log formats: binary (versions 1 to 3), text (4 to 7) and JSON.
#pragma once

#include <string_view>

#include "base/io/input_buffer.h"
#include "gamelog/record/record_builder.h"
#include "soccer/protocol/scanner.h"

namespace cls::gamelog {

/// True if a text log can hold the number: the limit of all integers in messages.
inline bool fits_text_log(int value) {
  return value >= -soccer::kMaxInteger && value <= soccer::kMaxInteger;
}

/// True if `start`, the first bytes of a file, can be those of a version 1 log, which has no
/// header.
bool looks_like_version_1(std::string_view start);

/// Reads everything after the header (docs/spec/log-formats.md 1.4 to 1.6); the version is the
/// record's. Values that a version lacks are 0 in the record: velocities, stamina, view and
/// counters before version
/// 3. Reading ends at a record of unknown kind, because its length is unknown.
void read_rcg_binary(base::InputBuffer& input, RecordBuilder& builder);

/// Reads everything after the header line `ULG4` to `ULG7` (docs/spec/log-formats.md 1.7).
/// Corrupt lines are reported in the record and skipped; records of unknown kinds are stored as
/// text.
void read_rcg_text(base::InputBuffer& input, RecordBuilder& builder);

/// Reads the array of a JSON log (docs/spec/log-formats.md 1.10), one element per line, in the
/// forms of rcssserver 17, 18 and 19, after the header line if there is one. Lines that are not
/// JSON are reported in the record and skipped.
void read_rcg_json(base::InputBuffer& input, RecordBuilder& builder);

}  // namespace cls::gamelog
