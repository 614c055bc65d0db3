// Writing a match record as a game log again, in this version or another.
#pragma once

#include "base/io/byte_sink.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// Writes version 4, 5, 6 or JSON; `version` must be one of these. A log of that version that was
/// read without damage comes out as it was, byte for byte. Between versions: what the target does
/// not know is left out (docs/formats/rcg.md lists it); what the source did not know is 0, the
/// stamina capacity -1; parameters that versions 1 and 2 lack are the defaults.
void write_rcg(const MatchRecord& record, RcgVersion version, base::ByteSink& sink);

}  // namespace cls::gamelog
