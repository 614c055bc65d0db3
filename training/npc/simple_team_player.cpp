// From a world model to the situation of the simple team, from its actions to skills.
#include "player/ball_skills/ball_skills.h"
#include "player/behaviors/automatic_play.h"
#include "player/behaviors/behaviors.h"
#include "player/looking/looking.h"
#include "player/movement/movement.h"
#include "player/simple_team/simple_team.h"
#include "training/npc/driver.h"

namespace cls::training {
namespace {

using player::ActionContext;
using player::PlayerState;
using player::Situation;
using player::TeamAction;
using player::TeamMode;
using player::WorldModel;
using soccer::PlayMode;
using soccer::Vec2;

// States carry floats.
double shortened(double value) { return static_cast<double>(static_cast<float>(value)); }
Vec2 shortened(Vec2 point) { return {shortened(point.x), shortened(point.y)}; }

TeamMode mode_of(const player::GameState& game) {
  if (soccer::is_penalty_mode(game.mode)) return TeamMode::kPenalty;
  if (game.goalie_catch) return TeamMode::kGoalieCatch;

  switch (game.mode) {
    case PlayMode::kPlayOn:
    case PlayMode::kDropBall:
      return TeamMode::kPlayOn;
    case PlayMode::kNull:
    case PlayMode::kBeforeKickOff:
    case PlayMode::kGoalLeft:
    case PlayMode::kGoalRight:
      return TeamMode::kBeforeKickOff;
    case PlayMode::kKickOffLeft:
    case PlayMode::kKickOffRight:
      return TeamMode::kKickOff;
    case PlayMode::kGoalKickLeft:
    case PlayMode::kGoalKickRight:
      return TeamMode::kGoalKick;
    case PlayMode::kFreeKickLeft:
    case PlayMode::kFreeKickRight:
      return TeamMode::kFreeKick;
    default:
      return TeamMode::kOther;
  }
}

int reach(int steps, int player_id) { return player_id == 0 ? player::kNeverReached : steps; }

void read_ball(const WorldModel& world, Situation& now) {
  now.ball = shortened(world.ball.position);
  now.ball_velocity = shortened(world.ball.velocity);
  now.ball_age = world.ball.pos_count;
  const player::InterceptTable& table = world.intercept;
  now.own_steps = table.self_steps;
  now.teammates_steps = reach(table.first_teammate_steps, table.first_teammate_id);
  now.opponents_steps = reach(table.first_opponent_steps, table.first_opponent_id);
  now.teammate_kicks = world.kickable_teammate();
  now.opponent_kicks = world.kickable_opponent();
}

Situation situation_of(const WorldModel& world) {
  Situation now;
  now.mode = mode_of(world.game);
  now.our_set_play = is_set_play_of(world.game, world.our_side);
  now.set_play_count = world.game.set_play_count;

  now.unum = world.unum;
  now.goalie = world.goalie;
  now.position = shortened(world.self.position);
  now.stamina = shortened(world.self.stamina);
  now.catch_probability = shortened(world.self.catch_probability);
  now.kickable = world.self.kickable;
  now.offside_line = shortened(world.lines.offside);
  read_ball(world, now);

  for (const PlayerState& player : world.teammates) {
    if (!player.position_valid() || player.unum == 0) continue;
    now.teammates.push_back({player.unum, shortened(player.position), shortened(player.velocity),
                             player.pos_count, player.goalie, player.tackling});
  }

  for (const PlayerState& player : world.opponents) {
    if (!player.position_valid() || player.unum == 0 || player.pos_count > Situation::kMaxAge) {
      continue;
    }
    now.opponents.push_back(shortened(player.position));
  }
  return now;
}

bool is_side_action(TeamAction::Kind kind) { return kind >= TeamAction::Kind::kWatchBall; }

bool execute_body(const TeamAction& action, ActionContext& c) {
  using Kind = TeamAction::Kind;
  const WorldModel& world = c.world;
  const auto first = static_cast<double>(action.first);
  const auto second = static_cast<double>(action.second);

  switch (action.kind) {
    case Kind::kSmartKick:
      return smart_kick(world, c.slots, action.point(), first, second, action.count);
    case Kind::kDribble:
      return dribble(world, c.memory.intention, c.slots, action.point(),
                     {player::kDribbleDistance, first, action.count, true});
    case Kind::kClearBall:
      return clear_ball(world, c.slots);
    case Kind::kIntercept:
      return intercept(world, c.slots, false, action.point());
    case Kind::kGoTo:
      return go_to_point(world, c.slots, action.point(), first, second);
    case Kind::kTackle:
      return tackle_to_point(world, c.slots, action.point(), first, 0.0);
    case Kind::kCatch:
      return c.slots.catch_ball();
    case Kind::kTurnToBall:
      return turn_to_ball(world, c.slots, 1);
    case Kind::kTurnTo:
      return turn_to_point(world, c.slots, action.point(), 1);
    case Kind::kMoveTo:
      return c.slots.move(action.point());
    case Kind::kKickOff:
      return before_kick_off(world, c.memory.view, c.slots, action.point());
    case Kind::kSearchBall:
      return neck_body_to_ball(world, c.memory.view, c.slots, 0.0);
    case Kind::kPenalty:
      return play_penalty(c);
    default:
      return false;
  }
}

void execute_neck(const TeamAction& action, ActionContext& c) {
  const player::ViewMemory& view = c.memory.view;
  switch (action.kind) {
    case TeamAction::Kind::kWatchBall:
      neck_turn_to_ball(c.world, view, c.slots);
      break;
    case TeamAction::Kind::kWatchBallOrScan:
      neck_turn_to_ball_or_scan(c.world, view, c.slots, action.count);
      break;
    case TeamAction::Kind::kWatchGoalieOrScan:
      neck_turn_to_goalie_or_scan(c.world, view, c.slots, 0);
      break;
    default:
      neck_scan_field(c.world, view, c.slots);
      break;
  }
}

}  // namespace

void play_as_simple_team(ActionContext& context) {
  player::ActionList list;
  play_simple_team(situation_of(context.world), list);
  player::AutomaticPlay automatic;
  automatic.preprocess = !list.places_itself;
  if (play_automatically(context, automatic)) return;

  bool done = false;
  for (const TeamAction& action : list.actions()) {
    if (is_side_action(action.kind)) {
      execute_neck(action, context);
    } else if (!done) {
      done = execute_body(action, context);
    }
  }
}

}  // namespace cls::training
