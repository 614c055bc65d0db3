// Context in which actions are executed, and the memory of an agent between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "player/commands/command_slots.h"
#include "player/commands/intention.h"
#include "player/looking/looking.h"
#include "player/planner/action_report.h"
#include "player/planner/plan.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::player {

/// Goalie free kick: whether and when the goalie moved with the caught ball.
struct GoalieKickMemory {
  bool moved = false;
  int move_cycle = 0;
};

/// A kick of the agent in a set play of its team, until another player touches the ball.
struct SetPlayKick {
  int cycle = -1;       ///< -1: none
  bool dashed = false;  ///< the agent has dashed since
};

/// The outcome of a requested action.
enum class ActionOutcome : std::uint8_t {
  kExecuted,
  kFailed,         ///< not possible in the situation
  kSkipped,        ///< not tried: an earlier main action succeeded
  kInvalid,        ///< contains a number that is not finite
  kUnimplemented,  ///< unknown to this proxy
};

/// The party that chose the body command of a decision.
enum class DecidedBy : std::uint8_t {
  kActions,  ///< the Playmaker's list
  kPreprocess,
  kSureShot,
  kIntention,
  kForceKick,
  kHeardPass,
  kNoReply,  ///< the proxy, without a reply
  kOwnPlay,  ///< the player itself, by a policy; no Playmaker was asked
};

/// How the latest decision was executed.
struct DecisionTrace {
  DecidedBy by = DecidedBy::kNoReply;
  std::vector<ActionOutcome> outcomes;  ///< of the list, action by action; empty: it was not tried
};

/// One per agent; a plain value.
struct ActionMemory {
  ViewMemory view;
  Intention intention;
  bool recovering = false;  ///< saves stamina until it has recovered (normal_dash_power)
  GoalieKickMemory goalie_kick;
  SetPlayKick set_play_kick;
  int ball_since =
      -1;  ///< cycle since which the agent has had the ball in play; -1: does not have it
  DecisionTrace trace;
};

/// Where an option leads.
struct OptionAim {
  int receiver = 0;            ///< uniform number of a pass; 0: none
  std::optional<Vec2> target;  ///< of the ball, without it of the agent; empty: not known before
  std::optional<double> room;  ///< distance of the nearest opponent to the target, meters
};

/// An option as a policy weighed it.
struct WeighedOption {
  int id = 0;          ///< option_ids.h
  double share = 0.0;  ///< probability, 0 to 1
  bool chosen = false;
  OptionAim aim;
};

/// The plan of a decision, and the party that chooses its action; or what a policy weighed.
struct PlanChoice {
  enum class Chooser : unsigned char {
    kProxy,      ///< the proxy: best node of the plan
    kPlaymaker,  ///< the Playmaker may choose
    kRequested,  ///< the Playmaker must choose before the decision continues
    kReplied,    ///< the Playmaker chose `node`
  };
  Chooser chooser = Chooser::kProxy;
  int node = -1;  ///< index of the chosen node; negative: no reply from the Playmaker
  Plan plan;      ///< empty until it is needed
  std::vector<WeighedOption> weighed;  ///< all legal options by id; empty: no policy had a choice
};

struct ActionContext {
  const WorldModel& world;
  ActionMemory& memory;
  CommandSlots& slots;
  NeckPlan& neck;  ///< queued neck plan; the last one wins
  ActionReport& report;
  PlanChoice& choice;
};

}  // namespace cls::player
