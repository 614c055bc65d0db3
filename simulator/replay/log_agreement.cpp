// Classes of steps, by the worlds before and after, and statistics of a log replay.
#include "simulator/replay/log_agreement.h"

#include <algorithm>
#include <cmath>

#include "base/text/enum_names.h"

namespace cls::simulator {
namespace {

constexpr auto kExcuses =
    base::enum_names<Excuse>("tackle", "catch", "foul", "random_place", "half_time", "noise",
                             "line", "toucher", "came_or_left");
static_assert(kExcuses.texts.size() == kExcuseCount);

constexpr auto kNames = base::enum_names<StepClass>(
    "ball_free", "ball_stopped", "ball_kick", "ball_tackle", "ball_catch", "ball_held",
    "ball_collision", "ball_post", "ball_placed", "ball_half_time", "player_idle", "player_blocked",
    "player_dash", "player_turn", "player_kick", "player_tackle", "player_catch", "player_move",
    "player_collision", "player_post", "player_placed", "player_half_time");
static_assert(kNames.texts.size() == kStepClassCount);

// True if the motion follows from the velocity alone.
bool moved_freely(Vec2 from, Vec2 to, Vec2 velocity_after, double decay) {
  constexpr double kExact = 1e-6;
  if (decay == 0.0) return true;
  const Vec2 off = to - (from + velocity_after / decay);
  return std::fabs(off.x) <= kExact && std::fabs(off.y) <= kExact;
}

bool kicked(const Player& before, const Player& after) {
  return after.counters.kick > before.counters.kick;
}

bool tackled_successfully(const Player& before, const Player& after) {
  return after.counters.tackle > before.counters.tackle && after.has(state::kTackle) &&
         !after.has(state::kTackleFault);
}

template <typename Predicate>
bool any_player(const World& before, const World& after, Predicate predicate) {
  for (std::size_t i = 0; i < after.players.size(); ++i) {
    if (predicate(before.players[i], after.players[i])) return true;
  }
  return false;
}

StepClass by_command(const Player& before, const Player& after) {
  const Counters& was = before.counters;
  const Counters& is = after.counters;
  if (is.move > was.move) return StepClass::kPlayerMove;
  if (after.has(state::kCatch)) return StepClass::kPlayerCatch;
  if (is.tackle > was.tackle) return StepClass::kPlayerTackle;
  if (after.has(state::kKick) && !before.has(state::kKick)) return StepClass::kPlayerKick;
  if (is.turn > was.turn) return StepClass::kPlayerTurn;
  if (is.dash > was.dash) return StepClass::kPlayerDash;
  return before.tackle_cycles > 0 || before.foul_cycles > 0 ? StepClass::kPlayerBlocked
                                                            : StepClass::kPlayerIdle;
}

}  // namespace

std::string_view name(Excuse excuse) { return kExcuses.name(excuse); }

double NoiseSample::mean() const {
  double sum = 0.0;
  for (const double share : shares) sum += share;
  return shares.empty() ? 0.0 : sum / static_cast<double>(shares.size());
}

double NoiseSample::largest() const { return shares.empty() ? 0.0 : std::ranges::max(shares); }

double NoiseSample::distance_to_uniform() const {
  std::vector<double> sorted = shares;
  std::ranges::sort(sorted);
  const double n = static_cast<double>(sorted.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double x = std::min(sorted[i], 1.0);
    distance = std::max({distance, std::fabs(x - static_cast<double>(i) / n),
                         std::fabs(x - static_cast<double>(i + 1) / n)});
  }
  return distance;
}

double LogAgreement::excused_share() const {
  const int all = steps() + uncounted;
  return all == 0 ? 0.0 : static_cast<double>(excused) / all;
}

std::string_view name(StepClass step_class) { return kNames.name(step_class); }

bool magnifies_rounding(StepClass step_class) {
  switch (step_class) {
    case StepClass::kBallCollision:
    case StepClass::kBallPost:
    case StepClass::kBallPlaced:
    case StepClass::kPlayerCollision:
    case StepClass::kPlayerPost:
    case StepClass::kPlayerPlaced:
      return true;
    default:
      return false;
  }
}

StepClass ball_class(const World& before, const World& after) {
  const auto collided = [](const Player&, const Player& now) {
    return now.has(state::kBallCollide);
  };
  const bool caught = any_player(before, after, [](const Player& was, const Player& now) {
    return now.counters.catches > was.counters.catches;
  });

  // Pushing the goalie moves the ball in its hands.
  const Slot catcher = after.ball_catcher;
  if (catcher != kNoPlayer && after.player(catcher).has(state::kPlayerCollide)) {
    return StepClass::kBallCollision;
  }
  if (caught) return StepClass::kBallCatch;
  if (catcher != kNoPlayer) return StepClass::kBallHeld;
  if (any_player(before, after, collided)) return StepClass::kBallCollision;

  const bool free = moved_freely(before.ball.position, after.ball.position, after.ball.velocity,
                                 after.params().ball_decay);
  if (!free) {
    return after.ball.velocity.is_zero() ? StepClass::kBallPlaced : StepClass::kBallPost;
  }

  if (any_player(before, after, tackled_successfully)) return StepClass::kBallTackle;
  if (any_player(before, after, kicked)) return StepClass::kBallKick;
  return soccer::mode_class(before.mode) == soccer::ModeClass::kRunning ? StepClass::kBallFree
                                                                        : StepClass::kBallStopped;
}

StepClass player_class(const World& before, const World& after, Slot slot) {
  const Player& was = before.player(slot);
  const Player& now = after.player(slot);
  const StepClass command = by_command(was, now);
  if (now.has(state::kPostCollide)) return StepClass::kPlayerPost;
  if (now.has(state::kBallCollide | state::kPlayerCollide)) return StepClass::kPlayerCollision;
  if (command == StepClass::kPlayerMove || command == StepClass::kPlayerCatch) return command;
  const bool free =
      moved_freely(was.position, now.position, now.velocity, after.type_of(now).player_decay);
  return free ? command : StepClass::kPlayerPlaced;
}

}  // namespace cls::simulator
