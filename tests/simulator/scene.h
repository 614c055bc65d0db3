// Small worlds set up by hand.
#pragma once

#include <string>

#include "simulator/senses/vision.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// A world of default rules with teams LeftTeam and RightTeam and nobody on the pitch.
World empty_pitch(const soccer::ServerParams& params = {});

/// A standing player whose client looks in synchronous mode if its version does so by itself.
Player& place(World& world, Side side, int unum, Vec2 position, double body_degrees = 0.0,
              int version = 18);

/// The see message of a player, with noise drawn from `seed`.
std::string see_text(const World& world, const Player& observer, std::uint64_t seed = 1);

/// The part of a see message that tells of one object: `see_part(text, "(b)")` gives
/// "((b) 3.7 10 0 0)"; empty if the object is not in it.
std::string see_part(const std::string& see, const std::string& name);

}  // namespace cls::simulator
