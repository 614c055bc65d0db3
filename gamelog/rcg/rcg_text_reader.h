// Reading game logs of versions 4, 5 and 6.
#pragma once

#include "base/io/input_buffer.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {

/// Reads everything behind the header line `ULG4`, `ULG5` or `ULG6` (log-formats 1.7). Damaged
/// lines are noted in the record and left out; records of unknown kinds are kept as they are.
void read_rcg_text(base::InputBuffer& input, RecordBuilder& builder);

}  // namespace cls::gamelog
