// Writes a match record as a game log of its own or another version.
#pragma once

#include "base/io/byte_sink.h"
#include "gamelog/record/match_record.h"

namespace cls::gamelog {

/// Writes version 4, 5, 6, 7 or JSON; `version` must be one of these. A log of the same version
/// that was read without errors is reproduced byte for byte. Between versions: data that the target
/// lacks is left out (docs/formats/rcg.md lists it); data that the source lacks is 0, the stamina
/// capacity -1; parameters that versions 1 and 2 lack have their defaults.
void write_rcg(const MatchRecord& record, RcgVersion version, base::ByteSink& sink);

}  // namespace cls::gamelog
