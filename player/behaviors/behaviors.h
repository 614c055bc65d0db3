// Behaviors: whole roles of a player, one function per Helios or Bhv action of the interface.
#pragma once

#include <cstdint>
#include <optional>

#include "player/commands/command_slots.h"
#include "player/looking/looking.h"
#include "player/planner/action_context.h"
#include "player/world/world_model.h"

namespace cls::player {

// Basic move.

/// Tackles, intercepts, blocks, supports, marks, or goes to the home position. True unless frozen.
bool basic_move(ActionContext& context);

/// The ways of moving without the ball. basic_move() makes the first that the situation asks for,
/// in this order, but never presses.
enum class MoveKind : std::uint8_t {
  kTackle,
  kIntercept,
  kPress,  ///< runs to the opponent with the ball, or the one who gets it first
  kBlock,
  kSupport,
  kMark,
  kHome,
};

/// The ways that the situation offers, and where they lead; empty: not offered.
struct Moves {
  MoveKind usual = MoveKind::kHome;  ///< that of basic_move()
  bool may_tackle = false;
  bool may_intercept = false;
  std::optional<Vec2> press;
  std::optional<Vec2> block;
  std::optional<Vec2> support;
  std::optional<Vec2> mark;
  Vec2 home;
};
Moves moves_of(const WorldModel& world, const ActionMemory& memory);

/// Moves in that way as basic_move() does; home may be shifted, meters. False without effect for a
/// way that is not offered.
bool make_move(ActionContext& context, const Moves& moves, MoveKind kind, Vec2 shift = {});

/// Factor of the dash power on the way to home positions. 1 for a player with as much stamina and
/// capacity left as an even pace until the end of the half needs, more for one with a surplus.
double running_pace(const WorldModel& world);

/// Dash power by situation and stamina (docs/spec/proxy-behavior.md 6.4). Sets `recovering` when
/// stamina falls below 50 percent, clears it above 70 percent.
double normal_dash_power(const WorldModel& world, bool& recovering);

/// Shoots at their goal (shoot()) and looks where it aims.
bool shoot_and_look(ActionContext& context);

// Goalie.

/// Catches the ball, or kicks it out, or calls goalie_move().
bool play_goalie(ActionContext& context);

/// Comes out for the ball when appropriate, otherwise takes a position that covers the goal.
bool goalie_move(ActionContext& context);

/// Clears the ball. False if it is not kickable.
bool goalie_kick(ActionContext& context);

/// Back pass rule: a ball last kicked by our team must not be caught, not even by its kicker after
/// a pass to it.
bool is_back_pass(const WorldModel& world);
/// True for points at least `inset` meters inside our penalty area.
bool in_own_penalty_area(Vec2 point, double inset = 0.0);

/// After catching the ball: waits for teammates, moves inside the penalty area to free space, and
/// kicks. Otherwise the goalie does goalie_move().
bool goalie_free_kick(ActionContext& context);

/// Position of the goalie for a ball position: for a far ball on the bisector of ball and goal,
/// otherwise the point that leaves the least of the goal open to shots from the ball and from
/// opponents it may be passed to.
Vec2 goalie_position(const WorldModel& world, Vec2 ball);

// Set plays.

/// Plays any role in all set play modes. False if frozen.
bool play_set_play(ActionContext& context);

/// Uniform number of the kicker: of the two players with the nearest home positions the clearly
/// nearer one, otherwise the one currently nearer. 0 if unknown.
int set_play_kicker(const WorldModel& world);

/// Goes behind the ball, waits for teammates, kicks.
bool kick_set_play(ActionContext& context);

/// Best planned pass, otherwise a pass to the nearest unmarked teammate, otherwise far upfield.
/// False only if the ball is not kickable.
bool kick_into_play(ActionContext& context);

/// Best planned pass; false if there is none.
bool play_planned_pass(ActionContext& context);

/// Forgets the kick when another player has touched the ball, or does not fetch it.
void update_set_play_kick(const WorldModel& world, SetPlayKick& kick);
/// Stores a kick that takes a set play of our team, and whether a dash follows.
void record_set_play_kick(const WorldModel& world, const CommandSlots& slots, SetPlayKick& kick);

/// True for the taker of a set play until another player touches the ball.
bool must_leave_ball(const WorldModel& world, const ActionMemory& memory);
/// Lets the ball roll; kicks it again if it stays, which is allowed before the first dash.
bool leave_ball(ActionContext& context);

// Shoot-out.

/// Plays the taker, the goalie or a waiting player. False outside shoot-out modes and if frozen.
bool play_penalty(ActionContext& context);

/// True if the agent takes our current kick.
bool is_penalty_taker(const WorldModel& world);

// Announced passes.

/// If a teammate announced a pass to the agent in this cycle: intercepts the ball or runs to the
/// announced point, and sets an intention. False without such a message.
bool receive_heard_pass(ActionContext& context);

/// Continues receiving. False, clearing the intention, when the ball is near, a teammate has it, or
/// the time is over.
bool continue_reception(ActionContext& context);

// Communication.

/// Says the ball near the agent and the players seen in this step; directs attention to the
/// teammate at the ball. Uses the remaining say capacity, and respects an attention already set.
/// False if it adds nothing.
bool communicate(ActionContext& context);

}  // namespace cls::player
