// Updates ball and players by heard say messages: less accurate than own observations, but with
// uniform numbers.
#include "player/perception/perception.h"

#include <algorithm>

#include "player/perception/say_message.h"
#include "player/tracking/tracking.h"

namespace cls::player {
namespace {

// Error model of heard positions, fitted to recorded matches: a grid part and a part proportional
// to the distance from the speaker.
constexpr double kGridDeviation = 0.25;
constexpr double kDeviationPerMeter = 0.03;
constexpr double kVelocityDeviation = 0.25;
constexpr int kHeardAge = 1;

double deviation_of(const WorldModel& world, int speaker, Vec2 position) {
  const PlayerState* speaking = world.teammate(speaker);
  constexpr double kUnknown = 20.0;
  const double far =
      speaking == nullptr ? kUnknown : soccer::distance(speaking->position, position);
  return kGridDeviation + kDeviationPerMeter * far;
}

/// Kalman update of one state component by a measured value with normal noise.
void kalman_update(ObjectEstimate& estimate, std::size_t axis, double value, double variance) {
  const double spread = estimate.at(axis, axis) + variance;
  VecN<4> h{};
  h[axis] = 1.0;
  const VecN<4> gain = covariance_with(estimate, h);
  const double own = estimate.at(axis, axis);

  if (own <= 0.0) return;
  const double share = own / spread;
  rank_one_update(estimate, gain, own, share * (value - estimate.mean[axis]), share * own);
}

double squared_mahalanobis(const ObjectEstimate& estimate, Vec2 position, double variance) {
  return square(position.x - estimate.mean[0]) / (estimate.at(0, 0) + variance) +
         square(position.y - estimate.mean[1]) / (estimate.at(1, 1) + variance);
}

ObjectEstimate make_estimate(Vec2 position, double variance, Vec2 velocity,
                             double velocity_variance) {
  ObjectEstimate estimate;
  estimate.mean = {position.x, position.y, velocity.x, velocity.y};
  estimate.at(0, 0) = estimate.at(1, 1) = variance;
  estimate.at(2, 2) = estimate.at(3, 3) = velocity_variance;
  return estimate;
}

void hear_ball(WorldModel& world, int speaker, const SayBall& said) {
  BallState& ball = world.ball;
  ball.heard_position = said.position;
  ball.heard_velocity = said.velocity;
  ball.heard_pos_count = ball.heard_vel_count = 0;
  if (ball.seen_pos_count == 0) return;  // the current see message is more accurate

  const double variance = square(deviation_of(world, speaker, said.position));
  BallTracker& tracker = world.ball_tracker;
  constexpr double kContradiction = 16.0;
  constexpr int kOwnObservationAge = 3;  // cycles for which an own observation takes precedence
  const bool agrees = tracker.tracked &&
                      squared_mahalanobis(tracker.state, said.position, variance) < kContradiction;

  if (agrees) {
    kalman_update(tracker.state, 0, said.position.x, variance);
    kalman_update(tracker.state, 2, said.velocity.x, square(kVelocityDeviation));
    kalman_update(tracker.state, 1, said.position.y, variance);
    kalman_update(tracker.state, 3, said.velocity.y, square(kVelocityDeviation));
  } else if (!tracker.tracked || ball.seen_pos_count > kOwnObservationAge) {
    tracker.state =
        make_estimate(said.position, variance, said.velocity, square(kVelocityDeviation));
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

// Cycles after which a seen number becomes unreliable: tracks get swapped where players cross far
// away.
constexpr int kReliableNumberAge = 30;

/// The only track near a heard position, unless its number was seen recently; null if ambiguous.
PlayerState* unconfirmed_track_at(PlayerList& list, Vec2 position, double variance) {
  PlayerState* best = nullptr;
  double least = 1e9;
  double second = 1e9;

  for (PlayerState& track : list) {
    const double squared = squared_mahalanobis(estimate_of(track), position, variance);
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
  return best->unum == 0 || best->unum_count >= kReliableNumberAge ? best : nullptr;
}

void record_heard_position(PlayerState& track, Vec2 position) {
  track.heard_position = position;
  track.heard_pos_count = 0;
}

void apply_heard_position(PlayerState& track, Vec2 position, double variance) {
  if (track.pos_count == 0) return;
  ObjectEstimate estimate = estimate_of(track);
  kalman_update(estimate, 0, position.x, variance);
  kalman_update(estimate, 1, position.y, variance);
  set_estimate(track, estimate);
  track.pos_count = kHeardAge;
}

void hear_player(WorldModel& world, int speaker, const SaidPlayer& said, const double* body) {
  const bool our_team = said.number <= soccer::kPlayersPerTeam;
  const int unum = our_team ? said.number : said.number - soccer::kPlayersPerTeam;
  if (our_team && unum == world.unum) return;

  const Side side = our_team ? world.our_side : world.their_side();
  PlayerList& list = our_team ? world.teammates : world.opponents;
  const double variance = square(deviation_of(world, speaker, said.position));

  PlayerState* track = find_number(list, side, unum);
  constexpr double kSame = 16.0;
  if (track != nullptr &&
      squared_mahalanobis(estimate_of(*track), said.position, variance) > kSame) {
    // A track with this number is elsewhere: the numbers were swapped unless its number was seen
    // recently.
    record_heard_position(*track, said.position);
    PlayerState* heard_track = unconfirmed_track_at(list, said.position, variance);
    if (track->unum_count < kReliableNumberAge || heard_track == nullptr) return;
    std::swap(track->unum, heard_track->unum);
    std::swap(track->goalie, heard_track->goalie);
    track = heard_track;
  }

  if (track == nullptr) {
    track = unconfirmed_track_at(list, said.position, variance);
    if (track != nullptr && track->unum != 0) track = nullptr;
  }

  if (track == nullptr) {
    track = new_player(world, side, unum);
    set_estimate(*track, make_estimate(said.position, variance, {}, 0.04));
    track->pos_count = kHeardAge;
  }

  track->unum = unum;
  forget_lost(world, side, unum);
  record_heard_position(*track, said.position);
  apply_heard_position(*track, said.position, variance);
  if (body != nullptr && track->body_count > kHeardAge) {
    track->body = AngleDeg(*body);
    track->body_count = kHeardAge;
  }

  sort_players(list);
}

struct SayMessageUpdate {
  WorldModel& world;
  int speaker;

  void player(const SaidPlayer& said, const double* body = nullptr) {
    hear_player(world, speaker, said, body);
  }
  void goalie(const SayGoalie& said) {
    // The opponents' goalie; the message has no number.
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
  void operator()(const Other&) {}  // no positions
};

}  // namespace

void apply_say_messages(WorldModel& world, int speaker, std::string_view text) {
  SayMessageUpdate update{world, speaker};
  while (!text.empty()) {
    const std::optional<SayMessage> message = parse_say_message(text, world.server());
    if (!message) return;
    std::visit(update, *message);
  }
}

}  // namespace cls::player
