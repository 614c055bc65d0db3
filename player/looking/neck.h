// Neck actions, computed for the position and body after this cycle's body command.
#pragma once

#include "player/commands/command_slots.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"

namespace cls::player {

// docs/spec/proxy-behavior.md 4.4. Call them after the body command is set. Each sets the neck slot
// and returns true unless noted; the last call wins. "Stale" means not seen for more than
// `count_threshold` cycles.

/// Direction unseen for longest.
bool neck_scan_field(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);
/// Direction of the most and longest unseen players; scans the field unless all 22 are tracked.
bool neck_scan_players(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Keeps the ball in view and scans as far as that allows; scans if the ball is out of reach.
bool neck_turn_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);
/// The ball if stale (always with threshold -1), otherwise a scan.
bool neck_turn_to_ball_or_scan(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                               int count_threshold);
/// Ball and player if the player is stale and both fit into the view cone, otherwise the ball.
/// False for an unknown player.
bool neck_turn_to_ball_and_player(const WorldModel& world, const ViewMemory& view,
                                  CommandSlots& slots, const PlayerState* player,
                                  int count_threshold);
/// The player if stale, otherwise a scan. False for an unknown player.
bool neck_turn_to_player_or_scan(const WorldModel& world, const ViewMemory& view,
                                 CommandSlots& slots, const PlayerState* player,
                                 int count_threshold);
/// Their goalie if stale, otherwise ball or scan.
bool neck_turn_to_goalie_or_scan(const WorldModel& world, const ViewMemory& view,
                                 CommandSlots& slots, int count_threshold);
/// The teammate ahead unseen for longest, otherwise ball or scan.
bool neck_turn_to_low_conf_teammate(const WorldModel& world, const ViewMemory& view,
                                    CommandSlots& slots);
/// The point if the neck can bring it into view, otherwise a scan.
bool neck_turn_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        soccer::Vec2 point);
/// To `angle` degrees relative to the body.
bool neck_turn_to_relative(const WorldModel& world, CommandSlots& slots, double angle);
/// Looks while intercepting in attack: opponent with the ball, goalie, teammates or ball.
bool neck_offensive_intercept(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Neck action that a behavior queues until all body commands are set. At most one per decision;
/// executed after the action list, it replaces the neck action of the Playmaker
/// (docs/spec/proxy-behavior.md 2.6).
struct NeckPlan {
  enum class Kind : unsigned char {
    kNone,
    kBall,
    kBallOrScan,
    kScan,
    kPoint,
    kGoalieOrScan,
    kOffensiveIntercept,
  };
  Kind kind = Kind::kNone;
  soccer::Vec2 point;  ///< for kPoint
};

/// False for kNone.
bool execute_neck_plan(const NeckPlan& plan, const WorldModel& world, const ViewMemory& view,
                       CommandSlots& slots);

}  // namespace cls::player
