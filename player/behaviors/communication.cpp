// Selects the most useful say messages for ten characters per cycle.
#include "player/behaviors/behaviors.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

#include "base/fixed_list.h"
#include "player/behaviors/behavior_parameters.h"
#include "player/perception/say_message.h"
#include "player/world/candidates.h"
#include "player/world/motion.h"

namespace cls::player {
namespace {

constexpr CommunicationParameters kNumbers = kBehaviors.communication;

bool silent_mode(PlayMode mode) {
  return before_play(mode) || mode == PlayMode::kTimeOver || soccer::is_penalty_mode(mode);
}

/// A player in the next cycle.
SaidPlayer said_player(const ActionContext& c, const PlayerState& player) {
  const bool ours = player.side == c.world.our_side;
  return {ours ? player.unum : player.unum + soccer::kPlayersPerTeam,
          player.position + player.velocity};
}

struct Seen {
  const PlayerState* player;
  double relevance;
};

using SeenPlayers = base::FixedList<Seen, 2 * PlayerList::capacity()>;

/// Adds a player before those of lower relevance.
void insert(const Seen& one, SeenPlayers& seen) {
  seen.push_back(one);
  for (std::size_t i = seen.size() - 1; i > 0 && seen[i - 1].relevance < seen[i].relevance; --i) {
    std::swap(seen[i - 1], seen[i]);
  }
}

/// Players seen in this step by descending relevance: near the ball, opponents before teammates.
SeenPlayers seen_now(const WorldModel& world) {
  SeenPlayers seen;
  for (const PlayerList* list : {&world.opponents, &world.teammates}) {
    for (const PlayerState& player : *list) {
      const bool sure = player.seen_pos_count == 0 && player.unum != 0 &&
                        player.unum_count < kNumbers.number_age && !player.ghost();
      if (!sure) continue;

      const double near = kNumbers.near_ball / (kNumbers.softening + player.dist_from_ball) +
                          kNumbers.near_agent / (kNumbers.softening + player.dist_from_self);
      insert({&player, near * (list == &world.opponents ? kNumbers.opponent : 1.0)}, seen);
    }
  }

  return seen;
}

bool say(ActionContext& c, const SayMessage& message) {
  std::string text;
  return append_say_message(message, c.world.server(), text) && c.slots.say(text);
}

/// Ball in the next cycle, including the agent's kick in this cycle.
SayBall next_ball(const ActionContext& c) {
  const WorldModel& world = c.world;
  Vec2 velocity = world.ball.velocity;
  if (const auto* kick = std::get_if<soccer::Kick>(&c.slots.body())) {
    const AngleDeg direction = world.self.body + kick->direction;
    velocity += soccer::polar(kick->power * world.self.kick_rate, direction);
    velocity = speed_limited(velocity, world.server().ball_speed_max);
  }

  return {world.ball.position + velocity, velocity * world.server().ball_decay};
}

bool say_ball(ActionContext& c, const SeenPlayers& seen) {
  const SayBall ball = next_ball(c);
  for (const Seen& each : seen) {
    if (each.player->side == c.world.our_side || each.player->body_count > 0) continue;
    const SayBallPlayer both{ball, said_player(c, *each.player), each.player->body.degrees()};
    return say(c, both) || say(c, ball);
  }

  return say(c, ball);
}

bool say_players(ActionContext& c, const SeenPlayers& seen) {
  for (std::size_t count = std::min<std::size_t>(3, seen.size()); count > 0; --count) {
    SayPlayers message;
    for (std::size_t i = 0; i < count; ++i) {
      message.players.push_back(said_player(c, *seen[i].player));
    }
    if (say(c, message)) return true;
  }
  return false;
}

/// True if the agent is near enough to the ball to report it.
bool should_say_ball(const WorldModel& world) {
  const BallState& ball = world.ball;
  if (ball.seen_pos_count > 0 || ball.seen_vel_count > 1) return false;
  const int nearest = std::min(world.intercept.first_teammate_steps, kNever);
  return world.self.kickable || world.intercept.best_self_steps() <= nearest ||
         ball.dist_from_self < kNumbers.say_ball;
}

/// Teammate for attentionto: the one that has the ball or gets it first; for the agent with the
/// ball, the field teammate nearest to the ball.
int attention_target(const WorldModel& world) {
  const PlayerState* first = world.player_by_id(world.kickable_teammate_id);
  const InterceptTable& table = world.intercept;
  const bool self_first =
      world.self.kickable || table.best_self_steps() < table.first_teammate_steps;
  if (first == nullptr && !self_first) first = world.player_by_id(table.first_teammate_id);
  if (first != nullptr && first->unum != 0) return first->unum;

  Lowest<int> nearest{std::numeric_limits<double>::infinity()};
  for (const PlayerState& teammate : world.teammates) {
    if (teammate.unum == 0 || teammate.goalie) continue;
    if (teammate.dist_from_self > kNumbers.attention) continue;
    nearest.offer(teammate.dist_from_ball, teammate.unum);
  }

  return nearest.value;
}

}  // namespace

bool communicate(ActionContext& c) {
  const WorldModel& world = c.world;
  if (silent_mode(world.game.mode)) return false;

  bool added = false;
  const int speaker = attention_target(world);
  const bool listening =
      world.self.attention_side == world.our_side && world.self.attention_unum == speaker;
  if (speaker != 0 && !c.slots.has_attention() && !listening) {
    added = c.slots.attention_to(world.our_side, speaker);
  }

  if (!world.self.position_valid() || world.game.see_time != world.game.time.cycle) return added;
  const SeenPlayers seen = seen_now(world);
  if (should_say_ball(world) && say_ball(c, seen)) added = true;
  return say_players(c, seen) || added;
}

}  // namespace cls::player
