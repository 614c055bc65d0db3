// Computes defense and offside lines.
#include "player/estimates/estimates.h"

#include <algorithm>
#include <utility>

#include "player/world/motion.h"
#include "soccer/pitch.h"

namespace cls::player {
namespace {

/// An x, and the age of the position that it comes from.
struct Line {
  double x = 0.0;
  int count = 0;
};

/// Rearmost and second rearmost player of a team, as x toward their own goal line.
struct LastTwo {
  Line last;
  Line second;

  void add(double x, int count) {
    if (x > last.x) {
      second = std::exchange(last, {x, count});
    } else if (x > second.x) {
      second = {x, count};
    }
  }
};

/// With unknown players, who may stand farther back, limits sudden jumps of the line away from the
/// own goal.
double damped(double line, double previous, bool all_known) {
  const double forward = previous - line;
  if (all_known || forward < 5.0 || forward > 13.0) return line;
  return previous - 1.0;
}

/// Distance an opponent not seen recently may have run back.
double run_back(const WorldModel& world, const PlayerState& player) {
  constexpr int kMaxCycles = 3;
  const bool ahead = player.position.x > world.ball.position.x;
  const int cycles = std::min(player.pos_count, kMaxCycles);
  const soccer::PlayerType& type = world.type_of(player);
  return ahead ? 0.0 : cycles * type.real_speed_max(world.server().max_dash_power);
}

double our_line(const WorldModel& world) {
  LastTwo two;
  if (world.self.position_valid()) two.add(-world.self.position.x, world.self.pos_count);
  for (const PlayerState& teammate : world.teammates)
    two.add(-teammate.position.x, teammate.pos_count);

  const bool all = world.teammates.size() + 1 >= soccer::kPlayersPerTeam;
  double line = damped(two.second.x, -world.lines.our_defense, all);
  if (world.ball.position_valid()) line = std::max(line, -world.ball.position.x);
  return -line;
}

Line their_line(const WorldModel& world) {
  LastTwo two;
  for (const PlayerState& opponent : world.opponents) {
    two.add(opponent.position.x + run_back(world, opponent), opponent.pos_count);
  }

  Line line = two.second;
  const double ball_x = world.ball.position.x;
  if (world.their_goalie_unum == 0 && ball_x > 20.0 && ball_x < 36.0 && two.last.x < 36.0) {
    line = two.last;  // the unseen goalie is behind them
  }

  const bool all = world.opponents.size() >= soccer::kPlayersPerTeam;
  line.x = damped(line.x, world.lines.their_defense, all);

  const BallState& ball = world.ball;
  const bool counts = world.game.mode != PlayMode::kBeforeKickOff && ball.pos_count <= 3;
  const double next_ball = ball.position.x + ball.velocity.x;
  if (counts && next_ball > line.x) line = {next_ball, ball.pos_count};
  return line;
}

/// Line of the second rearmost player; the rearmost if an unseen goalie must be behind.
double player_line(const PlayerList& players, const SelfState* self, double toward,
                   bool goalie_known) {
  LastTwo two;
  if (self != nullptr && self->position_valid()) two.add(toward * self->position.x, 0);
  for (const PlayerState& player : players) two.add(toward * player.position.x, player.pos_count);
  constexpr double kBoxLine = soccer::kHalfLength - soccer::kPenaltyAreaLength;
  const bool unseen_goalie = !goalie_known && two.last.x < kBoxLine;
  return toward * (unseen_goalie ? two.last.x : two.second.x);
}

bool offside_disabled(const WorldModel& world) {
  const GameState& game = world.game;
  const PlayMode mode = without_side(game.mode);
  const bool caught_by_them = game.goalie_catch && game.mode_side() != world.our_side;
  return !world.server().use_offside || caught_by_them || mode == PlayMode::kKickInLeft ||
         mode == PlayMode::kCornerKickLeft || mode == PlayMode::kGoalKickLeft;
}

}  // namespace

void update_team_lines(WorldModel& world) {
  TeamLines lines;
  lines.our_defense = our_line(world);

  const Line theirs = their_line(world);
  lines.their_defense = theirs.x;
  lines.our_defense_players =
      player_line(world.teammates, &world.self, -1.0, world.our_goalie_unum != 0);
  lines.their_defense_players =
      player_line(world.opponents, nullptr, 1.0, world.their_goalie_unum != 0);

  lines.offside = theirs.x;
  lines.offside_count = theirs.count;

  const int reached = std::min(world.intercept.our_steps(), world.intercept.first_opponent_steps);
  if (world.ball.position_valid() && reached < kNever) {
    const double x =
        ball_after(world.ball.position, world.ball.velocity, reached, world.server().ball_decay).x;
    if (x > lines.offside) {
      lines.offside = x;
      lines.offside_count = world.ball.pos_count;
    }
  }

  if (offside_disabled(world)) {
    lines.offside = soccer::kHalfLength;
    lines.offside_count = 0;
  }

  world.lines = lines;
}

}  // namespace cls::player
