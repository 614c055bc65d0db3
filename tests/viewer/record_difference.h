// Compares two match records bit by bit.
#pragma once

#include <string>

#include "gamelog/record/match_record.h"

namespace cls::tests {

/// The first difference: "x of frame 3, slot 7" or "notes"; empty if the records are equal.
std::string record_difference(const gamelog::MatchRecord& a, const gamelog::MatchRecord& b);

}  // namespace cls::tests
