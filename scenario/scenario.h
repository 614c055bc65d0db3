// A scenario: initial situation, sides and checks. Plain data.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "match/terms/endpoint.h"
#include "match/terms/option_texts.h"
#include "scenario/check.h"
#include "soccer/geometry.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::scenario {

/// Initial state of a player, in coordinates of the server (the left team attacks +x).
struct StartingPlace {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  std::optional<double> body;  ///< degrees; default: facing the opponents' goal
  std::optional<double> stamina;
  int cards = 0;  ///< 1: has a yellow card
};

/// Error for checks of RPCs, actions, commands or latencies of a `team:` side.
inline constexpr const char* kExternalTeamHasNoPlaymaker =
    "an external team has no Playmaker: its actions, commands, RPCs and latencies are unknown; "
    "check only events on the pitch";

struct ScenarioSide {
  match::Endpoint playmaker;
  /// By uniform number. Empty: all players, in kick-off positions; otherwise only these.
  std::map<int, StartingPlace> players;
};

/// docs/testing.md describes the file format. Time is counted in steps: cycles since the start,
/// including those with a stopped clock.
struct Scenario {
  std::string name;       ///< file name without ".json"
  std::string file;       ///< for errors and annotations
  std::string argument;   ///< of `cls test`, for reruns: the file, or the name if shipped
  std::string about;      ///< one sentence
  bool built_in = false;  ///< shipped with cls, and `file` is not there

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
  std::optional<match::Endpoint> trainer;             ///< handles GetTrainerActions
  match::OptionTexts options = {{"coach", "false"}};  ///< of match::match_options()

  int steps = 100;
  std::vector<StepTest> until;  ///< the run ends when any holds

  std::vector<Check> checks;
};

/// Index of a side in arrays of two.
constexpr std::size_t index_of(soccer::Side side) { return side == soccer::Side::kRight ? 1 : 0; }

}  // namespace cls::scenario
