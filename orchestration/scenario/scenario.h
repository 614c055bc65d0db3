// A scenario: a situation on the pitch, who plays it, and what must come of it. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/match/options/endpoint.h"
#include "orchestration/scenario/check.h"
#include "proxy/agent/player_agent.h"
#include "soccer/geometry.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::orchestration::scenario {

/// Where a player starts, in the server's axes (the left team attacks +x).
struct StartingPlace {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  std::optional<double> body;  ///< degrees on the pitch; else towards the other goal
  std::optional<double> stamina;
  int cards = 0;  ///< 1: has been shown the yellow card
};

/// Why a check about calls, actions, commands or latencies is not for a `team:` side.
inline constexpr const char* kForeignTeamHasNoPlaymaker =
    "a foreign team has no Playmaker: neither its actions, commands and calls nor their times are "
    "known, only what happens on the pitch";

struct ScenarioSide {
  match::Endpoint playmaker;
  /// By number. Empty: everybody plays, from the places of a kick-off; else only these do.
  std::map<int, StartingPlace> players;
};

/// docs/testing.md describes the file format. Time is counted in steps: cycles since the start,
/// stopped ones too.
struct Scenario {
  std::string name;      ///< file name without ".json"
  std::string file;      ///< for errors and annotations
  std::string argument;  ///< of `cls test`, to play it again: the file, or a shipped one's name
  std::string about;     ///< one sentence

  std::vector<std::uint64_t> seeds = {1};
  soccer::ServerParams server;
  soccer::PlayerParams player;
  soccer::PlayMode mode = soccer::PlayMode::kBeforeKickOff;
  int cycle = 0;  ///< game time at the start
  std::array<int, 2> score = {0, 0};
  soccer::Vec2 ball;
  soccer::Vec2 ball_velocity;
  std::array<ScenarioSide, 2> sides;  ///< left, right
  std::optional<soccer::Side> under_test;
  bool coach = false;                      ///< both teams bring one
  std::optional<match::Endpoint> trainer;  ///< who is asked GetTrainerActions

  int steps = 100;
  std::vector<StepTest> until;  ///< any of them ends the run
  int rpc_deadline_ms = 10'000;
  int max_missed = 20;
  proxy::OnLate on_late = proxy::OnLate::kHold;

  std::vector<Check> checks;
};

/// Index of a side in arrays of two.
constexpr std::size_t index_of(soccer::Side side) { return side == soccer::Side::kRight ? 1 : 0; }

}  // namespace cls::orchestration::scenario
