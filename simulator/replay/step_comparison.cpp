// Compares a simulated step with the recorded frame, with a tolerance per kind of value.
#include "simulator/replay/step_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "base/index.h"
#include "simulator/replay/frame_replay.h"
#include "simulator/replay/logged_match.h"

namespace cls::simulator {
namespace {

/// Maximum differences that the rounding of a log explains.
struct Tolerance {
  double position = 2e-4;
  double velocity = 2e-4;
  double body = 1e-3;
  double neck = 2e-3;
  double stamina = 0.02;
  double effort = 2e-6;
  double capacity = 1.0;
};

constexpr double kBodyAfterTurn = 0.1;
constexpr double kRoughPosition = 5e-3;  // where contacts magnify rounding
constexpr double kRoughVelocity = 1e-2;
// Records hold printed decimals in single precision.
constexpr double kRepresentation = 1.01;
// Minimum radius of noise that can be distinguished from rounding.
constexpr double kMinNoise = 0.02;
constexpr std::size_t kMaxGameMisses = 200;

std::string stamp(Clock clock) {
  return std::to_string(clock.time) + ',' + std::to_string(clock.stoppage);
}

std::string player_name(const Player& player) {
  return std::string(1, soccer::letter(player.side)) + std::to_string(player.unum);
}

class Comparison {
 public:
  Comparison(const SimulatedStep& step, LogAgreement& result)
      : step_(step), result_(result), overrides_(*step.after.overrides) {}

  void run() {
    compare_game();
    compare_ball();
    for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) compare_player(slot);
  }

 private:
  void compare_game() {
    const World& simulated = step_.after;
    const gamelog::Frame& recorded = step_.recorded;

    note(result_.mode, simulated.mode == recorded.mode, [&] {
      return "mode " + std::string(soccer::name(simulated.mode)) + ", recorded " +
             std::string(soccer::name(recorded.mode));
    });
    note(result_.clock, simulated.clock == step_.clock,
         [&] { return "clock " + stamp(simulated.clock); });

    bool same = true;
    for (std::size_t i = 0; i < simulated.teams.size(); ++i) {
      const gamelog::TeamFrame& team = recorded.teams[i];
      same = same && simulated.teams[i].score == team.score &&
             simulated.teams[i].penalty_goals == team.penalty_scored &&
             simulated.teams[i].penalty_kicks == team.penalties_taken();
    }
    note(result_.score, same, [] { return std::string("score"); });
  }

  void compare_ball() {
    const StepClass kind =
        step_.half_time ? StepClass::kBallHalfTime : ball_class(step_.before, step_.after);

    if (step_.half_time) excuse(Excuse::kHalfTime);
    if (overrides_.tackle.drawn.any()) excuse(Excuse::kTackle);
    if (overrides_.catch_ball.drawn.any()) excuse(Excuse::kCatch);
    if (step_.noise_decided.line) excuse(Excuse::kLine);
    if (step_.noise_decided.toucher) excuse(Excuse::kToucher);

    const Deviation off = ball_deviation(step_.after, step_.recorded);
    Tolerance allowed;
    if (magnifies_rounding(kind)) widen(allowed);

    const bool touched = shows_any(step_.recorded, state::kBallCollide);
    count(result_.ball, {kind, kNoPlayer, touched}, off, motion_misses(off, allowed));
    sample_ball_noise(kind);
  }

  void compare_player(Slot slot) {
    const auto i = base::index(slot);
    const Player& was = step_.before.player(slot);
    const Player& now = step_.after.player(slot);
    const gamelog::PlayerFrame& shown = step_.recorded.players[i];
    const bool is_enabled = (shown.state & state::kStand) != 0;

    if (was.enabled != is_enabled && now.enabled == was.enabled) {
      excuse(Excuse::kCameOrLeft);
      ++result_.uncounted;
      return close_step();
    }

    compare_bits(slot);
    if (!now.enabled || !is_enabled) return;

    const StepClass kind = step_.half_time ? StepClass::kPlayerHalfTime
                                           : player_class(step_.before, step_.after, slot);

    if (step_.half_time) excuse(Excuse::kHalfTime);
    if (overrides_.tackle.drawn[i]) excuse(Excuse::kTackle);
    if (overrides_.catch_ball.drawn[i]) excuse(Excuse::kCatch);
    if (overrides_.foul.drawn[i]) excuse(Excuse::kFoul);
    if (overrides_.placement.drawn[i]) excuse(Excuse::kRandomPlace);

    const Deviation off = player_deviation(step_.after, step_.recorded, slot);
    const Tolerance allowed = tolerance(was, now, kind);
    std::string misses = motion_misses(off, allowed);
    add(misses, "body", off.body, allowed.body);
    add(misses, "neck", off.neck, allowed.neck);
    add(misses, "stamina", off.stamina, allowed.stamina);
    add(misses, "effort or recovery", off.effort, allowed.effort);
    if (shown.capacity >= 0.0) add(misses, "capacity", off.capacity, allowed.capacity);

    // The referee stops players that it clears from the ball.
    const bool cleared = shown.velocity.is_zero() && !now.velocity.is_zero();
    const bool touched = (shown.state & kContacts & ~state::kPostCollide) != 0 || cleared;
    count(result_.players, {kind, slot, touched}, off, std::move(misses));
    sample_player_noise(slot, kind);
  }

  void compare_bits(Slot slot) {
    const Player& now = step_.after.player(slot);
    const std::uint32_t shown = step_.recorded.players[base::index(slot)].state;
    const std::uint32_t differs = now.state ^ shown;

    const bool only_contacts = differs != 0 && (differs & ~kContacts) == 0;
    if (!only_contacts || (!result_.has_noise && !is_borderline_contact(slot))) {
      note(result_.state, differs == 0, [&] {
        char text[64];
        std::snprintf(text, sizeof text, " state 0x%x, recorded 0x%x", now.state, shown);
        return player_name(now) + text;
      });
    }

    const Deviation off = player_deviation(step_.after, step_.recorded, slot);
    note(result_.counters, off.same_counters, [&] { return player_name(now) + " counters"; });
  }

  // True if rounding decides whether the player overlaps another object: the gap is tiny.
  bool is_borderline_contact(Slot slot) const {
    constexpr double kRounding = 5e-4;
    const Player& simulated = step_.after.player(slot);
    const gamelog::PlayerFrame& recorded = step_.recorded.players[base::index(slot)];
    const bool touches = simulated.has(kContacts);

    const double size = step_.after.type_of(simulated).player_size;
    const Vec2 at = touches ? recorded.position : simulated.position;
    const Vec2 ball = touches ? step_.recorded.ball_position : step_.after.ball.position;
    const double ball_gap = distance(at, ball) - size - step_.after.params().ball_size;
    bool is_borderline = std::fabs(ball_gap) < kRounding;
    for (Slot other = 0; other < soccer::kPlayersOnPitch; ++other) {
      const Player& player = step_.after.player(other);
      if (other == slot || !player.enabled) continue;

      const Vec2 position =
          touches ? step_.recorded.players[base::index(other)].position : player.position;
      const double gap = distance(at, position) - size - step_.after.type_of(player).player_size;
      is_borderline = is_borderline || std::fabs(gap) < kRounding;
    }
    return is_borderline;
  }

  Tolerance tolerance(const Player& was, const Player& now, StepClass kind) const {
    Tolerance allowed;
    if (magnifies_rounding(kind)) widen(allowed);

    const bool turned = now.counters.turn > was.counters.turn || now.has(state::kCatch);
    if (turned || step_.half_time) allowed.body = kBodyAfterTurn;
    return allowed;
  }

  static void widen(Tolerance& allowed) {
    allowed.position = kRoughPosition;
    allowed.velocity = kRoughVelocity;
  }

  static void add(std::string& misses, const char* what, double off, double allowed) {
    if (off <= allowed * kRepresentation) return;

    char text[96];
    std::snprintf(text, sizeof text, "%s%s %.5g > %.5g", misses.empty() ? "" : ", ", what, off,
                  allowed);
    misses += text;
  }

  static std::string motion_misses(const Deviation& off, const Tolerance& allowed) {
    std::string misses;
    add(misses, "position", off.position, allowed.position);
    add(misses, "velocity", off.velocity, allowed.velocity);
    return misses;
  }

  struct Subject {
    StepClass kind;
    Slot slot;
    bool touched;  ///< or was cleared in the record; noise decides whether in the simulation too
  };

  void count(Tally& tally, Subject what, const Deviation& off, std::string misses) {
    // The noise of a bounce off a post can be reconstructed (post_bounce.h).
    const bool is_bounce = what.kind == StepClass::kBallPost || what.kind == StepClass::kPlayerPost;
    const bool noise_matters =
        result_.has_noise && (what.touched || (magnifies_rounding(what.kind) && !is_bounce));

    if ((noise_matters || step_.half_time) && !misses.empty()) {
      if (!step_.half_time) excuse(Excuse::kNoise);
      ++result_.uncounted;
      return close_step();
    }

    close_step();
    ClassTally& of_class = result_.by_class[base::index(what.kind)];
    of_class.worst = std::max({of_class.worst, off.position, off.velocity});
    tally.add(misses.empty());
    of_class.add(misses.empty());

    if (misses.empty() || result_.misses.size() >= LogAgreement::kMaxMisses) return;
    result_.misses.push_back({step_.clock, what.slot, what.kind, std::move(misses)});
  }

  void excuse(Excuse why) {
    ++result_.by_cause[base::index(why)];
    excused_ = true;
  }

  void close_step() {
    if (std::exchange(excused_, false)) ++result_.excused;
  }

  template <typename Text>
  void note(Tally& tally, bool same, Text text) {
    tally.add(same);
    if (same || result_.game_misses.size() >= kMaxGameMisses) return;
    result_.game_misses.push_back(stamp(step_.clock) + ' ' + text());
  }

  void sample_ball_noise(StepClass kind) {
    const RecordedMotion& motion = overrides_.ball;
    if (!motion.explained || step_.after.wind.rand > 0.0) return;

    if (kind == StepClass::kBallFree && motion.noise_max >= kMinNoise) {
      result_.ball_noise.shares.push_back(motion.noise.length() / motion.noise_max);
    }

    const double expected = overrides_.push_noise_mean2 + motion.noise_max * motion.noise_max / 3.0;
    if (kind == StepClass::kBallKick && !step_.push_cut_off &&
        overrides_.push_noise_max >= kMinNoise) {
      result_.kick_noise.sum += motion.noise.squared_length() / expected;
      ++result_.kick_noise.n;
    }
  }

  void sample_player_noise(Slot slot, StepClass kind) {
    const RecordedMotion& motion = overrides_.players[base::index(slot)];
    if (!motion.explained || motion.noise_max < kMinNoise || magnifies_rounding(kind) ||
        step_.half_time || step_.after.wind.rand > 0.0) {
      return;
    }

    result_.player_noise.shares.push_back(motion.noise.length() / motion.noise_max);
  }

  static constexpr std::uint32_t kContacts =
      state::kBallToPlayer | state::kBallCollide | state::kPlayerCollide | state::kPostCollide;

  const SimulatedStep& step_;
  LogAgreement& result_;
  const ReplayOverrides& overrides_;
  bool excused_ = false;
};

}  // namespace

void compare_step(const SimulatedStep& step, LogAgreement& result) {
  Comparison(step, result).run();
}

}  // namespace cls::simulator
