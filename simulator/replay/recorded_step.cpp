// Tries possible outcomes of a step until one matches the record.
#include "simulator/replay/recorded_step.h"

#include "base/index.h"
#include "simulator/replay/frame_replay.h"
#include "simulator/replay/logged_match.h"
#include "simulator/replay/post_bounce.h"
#include "simulator/step.h"

namespace cls::simulator {
namespace {

constexpr int kDirections = 16;

bool is_off(const Deviation& deviation) {
  constexpr double kRounding = 2e-4;
  return deviation.position > kRounding || deviation.velocity > kRounding;
}

// Sets the arrival of a motion to the result of the search; returns false if there is none.
bool set_arrival(RecordedMotion& motion, const PostBounce& bounce) {
  const std::optional<Vec2> arrival = arrival_without_post(bounce);
  if (arrival) motion.arrival = *arrival;
  return arrival.has_value();
}

// A bounce off a post hides where the object came from. Reads the possible noise from `stepped` and
// writes the noise that explains the record to `start`.
bool find_bounces(World& start, const World& stepped, const gamelog::Frame& after) {
  bool found = false;
  const bool touched = shows_any(after, state::kBallCollide);
  if (!touched && stepped.overrides->ball.arrival && is_off(ball_deviation(stepped, after))) {
    const RecordedMotion& motion = stepped.overrides->ball;
    found = set_arrival(start.overrides->ball, {.from = start.ball.position,
                                                .expected = motion.expected,
                                                .reach = motion.reach,
                                                .radius = start.params().ball_size,
                                                .decay = start.params().ball_decay,
                                                .to = after.ball_position,
                                                .velocity = after.ball_velocity,
                                                .goal_width = start.params().goal_width});
  }

  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const auto i = base::index(slot);
    const gamelog::PlayerFrame& shown = after.players[i];
    const bool hit = ((shown.state | stepped.player(slot).state) & state::kPostCollide) != 0;
    if (!hit || !stepped.overrides->players[i].arrival ||
        !is_off(player_deviation(stepped, after, slot))) {
      continue;
    }

    const RecordedMotion& motion = stepped.overrides->players[i];
    const soccer::PlayerType& type = start.type_of(start.player(slot));
    const PostBounce bounce = {.from = start.player(slot).position,
                               .expected = motion.expected,
                               .reach = motion.reach,
                               .radius = type.player_size,
                               .decay = type.player_decay,
                               .to = shown.position,
                               .velocity = shown.velocity,
                               .goal_width = start.params().goal_width};
    found = set_arrival(start.overrides->players[i], bounce) || found;
  }
  return found;
}

/// Repeats a step from the same start until the mode is as recorded.
class Trials {
 public:
  Trials(World& world, Events& events, PlayMode wanted)
      : world_(world),
        events_(events),
        start_(world),
        event_count_(events.size()),
        wanted_(wanted) {}

  World& start() { return start_; }

  bool step_from_start() { return step_with(start_.overrides->ball.arrival, kNoPlayer); }

  /// kNoPlayer leaves the toucher unchanged.
  bool step_with(std::optional<Vec2> ball_arrival, Slot toucher) {
    world_ = start_;
    events_.resize(event_count_);
    world_.overrides->ball.arrival = ball_arrival;
    if (toucher != kNoPlayer) world_.referee.touch.toucher = toucher;

    step(world_, events_);
    return world_.mode == wanted_;
  }

  bool step_with_other_noise(const RecordedMotion& recorded, Slot toucher) {
    if (recorded.reach == 0.0) return false;

    for (int i = 0; i < 2 * kDirections; ++i) {
      const double share = i < kDirections ? 0.999 : 0.5;
      const Vec2 noise =
          soccer::polar_degrees(share * recorded.reach, 360.0 / kDirections * (i % kDirections));
      if (step_with(recorded.expected + noise, toucher)) return true;
    }
    return false;
  }

 private:
  World& world_;
  Events& events_;
  World start_;
  std::size_t event_count_;
  PlayMode wanted_;
};

}  // namespace

NoiseDecisions step_as_recorded(World& world, Events& events, const gamelog::Frame& after,
                                const std::vector<Slot>& contestants) {
  Trials trials(world, events, after.mode);
  bool same_mode = trials.step_from_start();
  if (find_bounces(trials.start(), world, after)) same_mode = trials.step_from_start();
  if (same_mode) return {};

  const RecordedMotion recorded = world.overrides->ball;
  const std::optional<Vec2> arrival = trials.start().overrides->ball.arrival;
  for (const Slot toucher : contestants) {
    if (trials.step_with(arrival, toucher)) return {false, true};
  }

  if (trials.step_with_other_noise(recorded, kNoPlayer)) return {true, false};
  for (const Slot toucher : contestants) {
    if (trials.step_with_other_noise(recorded, toucher)) return {true, true};
  }

  trials.step_from_start();
  return {};
}

}  // namespace cls::simulator
