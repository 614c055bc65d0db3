// A moment of a recorded match as the start of an episode.
#pragma once

#include <memory>
#include <string>

#include "analysis/play/flow.h"
#include "base/result.h"
#include "soccer/per_side.h"
#include "training/episode/episode.h"
#include "training/episode/setup.h"

namespace cls::review {

/// Why the moments of a match cannot be played again; empty: they can.
std::string why_not_played(const gamelog::MatchRecord& record);

/// The rules, the player types and the goalies of a match, played by `drivers`. The match must be
/// one whose moments can be played again.
base::Result<std::shared_ptr<const training::Setup>> setup_of(
    const gamelog::MatchRecord& record, soccer::PerSide<training::Driver> drivers);

/// Steps before a moment, which the players perceive before they decide.
inline constexpr std::size_t kWarmUp = 10;

/// True if the steps before `frame` are recorded without a gap in live play.
bool has_warm_up(const analysis::Flow& flow, std::size_t frame);

/// The state of `frame` and kWarmUp steps before it.
training::Start start_at(const analysis::Flow& flow, std::size_t frame);

}  // namespace cls::review
