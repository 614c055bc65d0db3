// One decision of a player as the decision debugger shows it: estimates, reply, commands.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/text/enum_names.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::viewer {

/// Age of what is not known.
constexpr int kUnknownAge = -1;

/// Where the player estimates another player. Positions in meters and directions in degrees, as in
/// the game log: the left team attacks to the right.
struct EstimatedPlayer {
  int age = kUnknownAge;  ///< cycles since the position was observed
  soccer::Vec2 position;
};

/// A player of unknown number.
struct UnnumberedPlayer {
  int id = 0;  ///< the same in all decisions while the player is tracked
  soccer::Side side = soccer::Side::kNeutral;  ///< neutral: unknown
  EstimatedPlayer estimate;
};

/// Who chose the body command; the numbers of the format.
enum class DecisionMaker : std::uint8_t {
  kActions,
  kPreprocess,
  kSureShot,
  kIntention,
  kForceKick,
  kHeardPass,
  kNoReply,
  kOwnPlay,
};
constexpr auto kDecisionMakerNames =
    base::enum_names<DecisionMaker>("actions", "preprocess", "sure_shot", "intention", "force_kick",
                                    "heard_pass", "no_reply", "policy");

struct DecisionSample {
  int cycle = 0;
  int stopped = 0;  ///< cycles since the clock stopped

  soccer::Vec2 self;
  double self_body = 0.0;
  double self_neck = 0.0;
  int self_age = kUnknownAge;

  soccer::Vec2 ball;
  soccer::Vec2 ball_velocity;
  int ball_age = kUnknownAge;
  int ball_velocity_age = kUnknownAge;

  /// By slot; the player itself has no entry.
  std::array<EstimatedPlayer, soccer::kPlayersOnPitch> players;
  std::vector<UnnumberedPlayer> unnumbered;

  // Cycles to the ball; kUnknownAge: cannot reach it.
  int own_reach = kUnknownAge;
  int teammate_reach = kUnknownAge;
  int opponent_reach = kUnknownAge;

  DecisionMaker maker = DecisionMaker::kNoReply;
  int call = 0;  ///< outcome of the call: 0 ok, else why the decision was missed
  /// A line per action: a letter for its outcome (e executed, f failed, s skipped, i invalid, u
  /// unimplemented, - not tried), a space, the action.
  std::string reply;
  std::string commands;  ///< as sent to the soccer server
  std::string plan;      ///< what was considered: decision_plan.h; empty: nothing
  std::string drawings;  ///< a line per text or shape that the Playmaker shows; empty: none
  std::int64_t latency_us = 0;
};

}  // namespace cls::viewer
