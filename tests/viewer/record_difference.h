// Compares two match records bit by bit.
#pragma once

#include <string>

#include "base/result.h"
#include "gamelog/record/match_record.h"
#include "viewer/stream/chunk_reader.h"

namespace cls::tests {

/// The first difference: "x of frame 3, slot 7" or "notes"; empty if the records are equal.
std::string record_difference(const gamelog::MatchRecord& a, const gamelog::MatchRecord& b);

/// The same for a match that was read, or the error.
std::string record_difference(const gamelog::MatchRecord& a,
                              const base::Result<viewer::StreamMatch>& b);

}  // namespace cls::tests
