// Trying outcomes.
#include "simulator/replay/recorded_step.h"

#include "simulator/replay/logged_frames.h"
#include "simulator/replay/post_bounce.h"
#include "simulator/replay/replay.h"
#include "simulator/step.h"

namespace cls::simulator {
namespace {

constexpr int kDirections = 16;

bool is_off(const Deviation& deviation) {
  constexpr double kRounding = 2e-4;
  return deviation.position > kRounding || deviation.velocity > kRounding;
}

// Takes over what a search finds; true if it found anything.
bool take(ShownMotion& motion, const PostBounce& bounce) {
  const std::optional<Vec2> arrival = arrival_without_post(bounce);
  if (arrival) motion.arrival = *arrival;
  return arrival.has_value();
}

PostBounce recorded_bounce(const World& start, const ShownMotion& motion, Vec2 from) {
  PostBounce bounce;
  bounce.from = from;
  bounce.expected = motion.expected;
  bounce.reach = motion.reach;
  bounce.goal_width = start.params().goal_width;
  return bounce;
}

// What bounced off a post came from where its place no longer says: `stepped` tells what noise
// could do, `start` gets the noise that explains the record.
bool find_bounces(World& start, const World& stepped, const gamelog::Frame& after) {
  bool found = false;
  const bool touched = shows_any(after, state::kBallCollide);
  if (!touched && stepped.forced->ball.arrival && is_off(ball_deviation(stepped, after))) {
    PostBounce bounce = recorded_bounce(start, stepped.forced->ball, start.ball.position);
    bounce.radius = start.params().ball_size;
    bounce.decay = start.params().ball_decay;
    bounce.to = after.ball_position;
    bounce.velocity = after.ball_velocity;
    found = take(start.forced->ball, bounce);
  }
  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const auto i = static_cast<std::size_t>(slot);
    const gamelog::PlayerFrame& shown = after.players[i];
    const bool hit = ((shown.state | stepped.player(slot).state) & state::kPostCollide) != 0;
    if (!hit || !stepped.forced->players[i].arrival ||
        !is_off(player_deviation(stepped, after, slot))) {
      continue;
    }
    PostBounce bounce =
        recorded_bounce(start, stepped.forced->players[i], start.player(slot).position);
    const soccer::PlayerType& type = start.type_of(start.player(slot));
    bounce.radius = type.player_size;
    bounce.decay = type.player_decay;
    bounce.to = shown.position;
    bounce.velocity = shown.velocity;
    found = take(start.forced->players[i], bounce) || found;
  }
  return found;
}

/// Steps again and again from one start, until the mode is the recorded one.
class Trials {
 public:
  Trials(World& world, Events& events, PlayMode wanted)
      : world_(world), events_(events), start_(world), said_(events.size()), wanted_(wanted) {}

  World& start() { return start_; }

  bool step_from_start() { return step_with(start_.forced->ball.arrival, kNobody); }

  /// As it is for no toucher.
  bool step_with(std::optional<Vec2> ball_arrival, Slot toucher) {
    world_ = start_;
    events_.resize(said_);
    world_.forced->ball.arrival = ball_arrival;
    if (toucher != kNobody) world_.referee.touch.toucher = toucher;
    step(world_, events_);
    return world_.mode == wanted_;
  }

  bool step_along_other_lines(const ShownMotion& shown, Slot toucher) {
    if (shown.reach == 0.0) return false;
    for (int i = 0; i < 2 * kDirections; ++i) {
      const double share = i < kDirections ? 0.999 : 0.5;
      const Vec2 noise =
          soccer::polar_degrees(share * shown.reach, 360.0 / kDirections * (i % kDirections));
      if (step_with(shown.expected + noise, toucher)) return true;
    }
    return false;
  }

 private:
  World& world_;
  Events& events_;
  World start_;
  std::size_t said_;
  PlayMode wanted_;
};

}  // namespace

OpenOutcomes step_as_recorded(World& world, Events& events, const gamelog::Frame& after,
                              const std::vector<Slot>& contestants) {
  Trials trials(world, events, after.mode);
  bool same_mode = trials.step_from_start();
  if (find_bounces(trials.start(), world, after)) same_mode = trials.step_from_start();
  if (same_mode) return {};
  const ShownMotion shown = world.forced->ball;
  const std::optional<Vec2> arrival = trials.start().forced->ball.arrival;
  for (const Slot toucher : contestants) {
    if (trials.step_with(arrival, toucher)) return {false, true};
  }
  if (trials.step_along_other_lines(shown, kNobody)) return {true, false};
  for (const Slot toucher : contestants) {
    if (trials.step_along_other_lines(shown, toucher)) return {true, true};
  }
  trials.step_from_start();
  return {};
}

}  // namespace cls::simulator
