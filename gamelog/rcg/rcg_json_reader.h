// Reading game logs in JSON.
#pragma once

#include "base/io/input_buffer.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {

/// Reads the array that a JSON log is (log-formats 1.10), one element a line, in the forms of
/// servers 17, 18 and 19; a header line must have been read. Lines that are no JSON are noted as
/// damage and left out.
void read_rcg_json(base::InputBuffer& input, RecordBuilder& builder);

}  // namespace cls::gamelog
