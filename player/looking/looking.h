// Looking: actions of body and neck, of the neck alone, and of the view; body commands as values.
#pragma once

#include <vector>

#include "player/commands/command_slots.h"
#include "player/world/view_cone.h"
#include "player/world/world_model.h"
#include "soccer/commands/player_command.h"

namespace cls::player {

// docs/spec/proxy-behavior.md 4.4. All set the body slot, and fall back to scan_field() without a
// valid own (or ball) position.

/// Turns the body to the point; the neck adds what one turn cannot reach.
bool body_neck_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        Vec2 point);
bool body_neck_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Turns only the neck if it reaches the point with `angle_buf` degrees margin, otherwise also the
/// body.
bool neck_body_to_point(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                        Vec2 point, double angle_buf);
bool neck_body_to_ball(const WorldModel& world, const ViewMemory& view, CommandSlots& slots,
                       double angle_buf);

/// Turns around with a wide view; searches a lost ball at its last seen position, then in the
/// direction unseen for longest.
bool scan_field(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Regains orientation: scan_field() with high view quality.
bool emergency(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

/// Turns body and neck to the direction unseen for longest.
bool look_around(const WorldModel& world, const ViewMemory& view, CommandSlots& slots);

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
                        Vec2 point);
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
  Vec2 point;  ///< for kPoint
};

/// False for kNone.
bool execute_neck_plan(const NeckPlan& plan, const WorldModel& world, const ViewMemory& view,
                       CommandSlots& slots);

/// Width with a see message every cycle.
bool view_synch(CommandSlots& slots);
/// Width by the distance of play (docs/spec/proxy-behavior.md 2.4).
bool view_tactical(const WorldModel& world, CommandSlots& slots);

/// Moves the focus point to `point`, or as near as its range (40 m) and the view cone allow. Call
/// it after body and neck: the focus direction is relative to the face.
bool focus_to_point(const WorldModel& world, CommandSlots& slots, Vec2 point);
/// Moves the focus point back to the agent.
bool focus_reset(const WorldModel& world, CommandSlots& slots);

/// Sets the body slot to the command, clamped and rounded like that of a Playmaker. `body` is Dash,
/// Turn, Kick, Tackle, Catch or Move; false, changing nothing, for others and for those that the
/// server would reject.
bool set_body_command(const WorldModel& world, const soccer::PlayerCommand& body,
                      CommandSlots& slots);

}  // namespace cls::player
