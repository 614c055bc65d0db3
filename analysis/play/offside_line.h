// The offside line of a frame.
#pragma once

#include <cstddef>

#include "gamelog/record/match_record.h"

namespace cls::analysis {

/// How far forward (as the attacking team sees it, its goal behind) a team mate may stand: the
/// second last connected opponent, goalkeeper included; at least the ball and the half line.
double offside_line(const gamelog::MatchRecord& record, std::size_t frame,
                    std::size_t attacking_team);

}  // namespace cls::analysis
