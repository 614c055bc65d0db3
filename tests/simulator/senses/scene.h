// Small worlds for tests of senses.
#pragma once

#include <string>

#include "simulator/senses/vision.h"
#include "simulator/world/world.h"

namespace cls::simulator {

/// A world with default rules and teams LeftTeam and RightTeam, without players.
World empty_pitch(const soccer::ServerParams& params = {});

/// Places a player at rest; the view mode is synchronous if that is the default of the version.
Player& place(World& world, Side side, int unum, Vec2 position, double body_degrees = 0.0,
              int version = 18);

/// The see message of a player, with noise drawn from `seed`.
std::string see_text(const World& world, const Player& observer, std::uint64_t seed = 1);

/// The observation of one object: `see_part(text, "(b)")` returns "((b) 3.7 10 0 0)", or an empty
/// string.
std::string see_part(const std::string& see, const std::string& name);

}  // namespace cls::simulator
