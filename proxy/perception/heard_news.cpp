// Merging hearsay: less sure than own looks, but it knows who is who.
#include "proxy/perception/heard_news.h"

#include <algorithm>
#include <cmath>

#include "proxy/perception/say_message.h"
#include "proxy/tracking/ball_tracking.h"
#include "proxy/tracking/player_tracking.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Side;
using soccer::Vec2;

// How far off a heard place is, from recorded matches: a part for the grid, and a part of the
// speaker's distance.
constexpr double kGridDeviation = 0.25;
constexpr double kDeviationPerMetre = 0.03;
constexpr double kVelocityDeviation = 0.25;
constexpr int kHeardAge = 1;

double square(double x) { return x * x; }

double deviation_of(const WorldModel& world, int speaker, Vec2 place) {
  const PlayerState* mate = world.teammate(speaker);
  constexpr double kUnknown = 20.0;
  const double far = mate == nullptr ? kUnknown : soccer::distance(mate->position, place);
  return kGridDeviation + kDeviationPerMetre * far;
}

/// A measured value with normal noise, as an interval without width.
void measure(MovingBelief& belief, std::size_t axis, double value, double variance) {
  const double spread = belief.at(axis, axis) + variance;
  VecN<4> h{};
  h[axis] = 1.0;
  const VecN<4> gain = covariance_with(belief, h);
  const double own = belief.at(axis, axis);
  if (own <= 0.0) return;
  const double share = own / spread;
  regress(belief, gain, own, share * (value - belief.mean[axis]), share * own);
}

double squared_surprise(const MovingBelief& belief, Vec2 place, double variance) {
  return square(place.x - belief.mean[0]) / (belief.at(0, 0) + variance) +
         square(place.y - belief.mean[1]) / (belief.at(1, 1) + variance);
}

MovingBelief belief_from(Vec2 place, double variance, Vec2 velocity, double velocity_variance) {
  MovingBelief belief;
  belief.mean = {place.x, place.y, velocity.x, velocity.y};
  belief.at(0, 0) = belief.at(1, 1) = variance;
  belief.at(2, 2) = belief.at(3, 3) = velocity_variance;
  return belief;
}

void hear_ball(WorldModel& world, int speaker, const SayBall& said) {
  BallState& ball = world.ball;
  ball.heard_position = said.position;
  ball.heard_velocity = said.velocity;
  ball.heard_pos_count = ball.heard_vel_count = 0;
  if (ball.seen_pos_count == 0) return;  // a look of this moment knows better
  const double variance = square(deviation_of(world, speaker, said.position));
  BallTracker& tracker = world.ball_tracker;
  constexpr double kContradiction = 16.0;
  constexpr int kOwnLookCounts = 3;  // cycles for which an own look is believed more
  const bool agrees =
      tracker.tracked && squared_surprise(tracker.state, said.position, variance) < kContradiction;
  if (agrees) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const bool x = axis == 0;
      measure(tracker.state, axis, x ? said.position.x : said.position.y, variance);
      measure(tracker.state, axis + 2, x ? said.velocity.x : said.velocity.y,
              square(kVelocityDeviation));
    }
  } else if (!tracker.tracked || ball.seen_pos_count > kOwnLookCounts) {
    tracker.state = belief_from(said.position, variance, said.velocity, square(kVelocityDeviation));
    tracker.tracked = true;
    ball.ghost_count = 0;
  } else {
    return;
  }
  ball.pos_count = std::min(ball.pos_count, kHeardAge);
  ball.relative_pos_count = std::min(ball.relative_pos_count, kHeardAge);
  ball.vel_count = std::min(ball.vel_count, kHeardAge);
  publish_ball(world);
}

PlayerState* find_number(PlayerList& list, int unum) {
  PlayerState* found = std::find_if(list.begin(), list.end(),
                                    [unum](const PlayerState& p) { return p.unum == unum; });
  return found == list.end() ? nullptr : found;
}

// Cycles after which a number that was read is open to doubt: tracks get mixed up where players
// cross far away.
constexpr int kReadLately = 30;

/// The track that is clearly meant by a heard place: near enough, no other about as near, and not
/// one whose number was read lately.
PlayerState* doubtful_at(PlayerList& list, Vec2 place, double variance) {
  PlayerState* best = nullptr;
  double least = 1e9;
  double second = 1e9;
  for (PlayerState& track : list) {
    const double squared = squared_surprise(belief_of(track), place, variance);
    if (squared < least) {
      second = least;
      least = squared;
      best = &track;
    } else {
      second = std::min(second, squared);
    }
  }
  constexpr double kNear = 9.0;
  constexpr double kClear = 6.0;
  if (best == nullptr || least > kNear || second < least + kClear) return nullptr;
  return best->unum == 0 || best->unum_count >= kReadLately ? best : nullptr;
}

void note_heard(PlayerState& track, Vec2 place) {
  track.heard_position = place;
  track.heard_pos_count = 0;
}

void believe_place(PlayerState& track, Vec2 place, double variance) {
  if (track.pos_count == 0) return;
  MovingBelief belief = belief_of(track);
  measure(belief, 0, place.x, variance);
  measure(belief, 1, place.y, variance);
  set_belief(track, belief);
  track.pos_count = kHeardAge;
}

void hear_player(WorldModel& world, int speaker, const SaidPlayer& said, const double* body) {
  const bool ours = said.number <= soccer::kPlayersPerTeam;
  const int unum = ours ? said.number : said.number - soccer::kPlayersPerTeam;
  if (ours && unum == world.unum) return;
  const Side side = ours ? world.our_side : world.their_side();
  PlayerList& list = ours ? world.teammates : world.opponents;
  const double variance = square(deviation_of(world, speaker, said.position));
  PlayerState* track = find_number(list, unum);
  constexpr double kSame = 16.0;
  if (track != nullptr && squared_surprise(belief_of(*track), said.position, variance) > kSame) {
    // Somebody wears this number elsewhere; unless it was read there lately, names were mixed up.
    note_heard(*track, said.position);
    PlayerState* meant = doubtful_at(list, said.position, variance);
    if (track->unum_count < kReadLately || meant == nullptr) return;
    std::swap(track->unum, meant->unum);
    std::swap(track->goalie, meant->goalie);
    track = meant;
  }
  if (track == nullptr) {
    track = doubtful_at(list, said.position, variance);
    if (track != nullptr && track->unum != 0) track = nullptr;
  }
  if (track == nullptr) {
    track = new_player(world, side, unum);
    set_belief(*track, belief_from(said.position, variance, {}, 0.04));
    track->pos_count = kHeardAge;
  }
  track->unum = unum;
  forget_lost(world, side, unum);
  note_heard(*track, said.position);
  believe_place(*track, said.position, variance);
  if (body != nullptr && track->body_count > kHeardAge) {
    track->body = AngleDeg(*body);
    track->body_count = kHeardAge;
  }
  sort_players(list);
}

struct News {
  WorldModel& world;
  int speaker;

  void player(const SaidPlayer& said, const double* body = nullptr) {
    hear_player(world, speaker, said, body);
  }
  void goalie(const SayGoalie& said) {
    // The opponents' goalie; its number is not said.
    const int unum = world.their_goalie_unum;
    if (unum == 0) return;
    player({unum + soccer::kPlayersPerTeam, said.position}, &said.body);
  }

  void operator()(const SayBall& m) { hear_ball(world, speaker, m); }
  void operator()(const SayPass& m) { hear_ball(world, speaker, m.ball); }
  void operator()(const SayGoalie& m) { goalie(m); }
  void operator()(const SayGoalieAndPlayer& m) {
    goalie(m.goalie);
    player(m.player);
  }
  void operator()(const SayBallGoalie& m) {
    hear_ball(world, speaker, m.ball);
    goalie(m.goalie);
  }
  void operator()(const SayPlayers& m) {
    for (const SaidPlayer& said : m.players) player(said);
  }
  void operator()(const SaySelf& m) { player({speaker, m.position}, &m.body); }
  void operator()(const SayTeammate& m) { player({m.unum, m.position}, &m.body); }
  void operator()(const SayOpponent& m) {
    player({m.unum + soccer::kPlayersPerTeam, m.position}, &m.body);
  }
  void operator()(const SayBallPlayer& m) {
    hear_ball(world, speaker, m.ball);
    player(m.player, &m.body);
  }
  template <typename Other>
  void operator()(const Other&) {}  // nothing about where somebody is
};

}  // namespace

void take_news(WorldModel& world, int speaker, std::string_view text) {
  News news{world, speaker};
  while (!text.empty()) {
    const std::optional<SayMessage> message = take_say_message(text, world.server());
    if (!message) return;
    std::visit(news, *message);
  }
}

}  // namespace cls::proxy
