// Finding touches in the counters and following the ball from one to the next.
#include "analysis/play/flow.h"

#include <limits>
#include <optional>

namespace cls::analysis {
namespace {

constexpr std::size_t kKick = static_cast<std::size_t>(gamelog::Counter::kKick);
constexpr std::size_t kCatch = static_cast<std::size_t>(gamelog::Counter::kCatch);
constexpr std::size_t kTackle = static_cast<std::size_t>(gamelog::Counter::kTackle);

// Beyond what a ball can do in a step: the referee has put it somewhere.
constexpr double kPlacedMargin = 0.3;
// A ball that rolled faster than this does not come to rest by itself in one step.
constexpr double kStillRolls = 1e-3;

// Counters only grow, unless another match begins.
bool follows(const gamelog::MatchRecord& record, std::size_t frame) {
  return frame > 0 && record.time[frame] >= record.time[frame - 1];
}

// What a player did to the ball between two frames.
class TouchTest {
 public:
  TouchTest(const gamelog::MatchRecord& record, std::size_t entry)
      : before_(record.players.state[entry - gamelog::kSlots]),
        now_(record.players.state[entry]),
        counters_before_(record.players.counters[entry - gamelog::kSlots]),
        counters_now_(record.players.counters[entry]),
        version_(record.version) {}

  std::optional<TouchKind> kind() const {
    if ((before_ & now_ & gamelog::kStateEnabled) == 0) return std::nullopt;
    if (kicked()) return TouchKind::kKick;
    if (tackled() && (now_ & gamelog::kStateTackle) != 0 &&
        (now_ & gamelog::kStateTackleFailed) == 0) {
      return TouchKind::kTackle;
    }
    if (caught() && (now_ & gamelog::kStateCatch) != 0) {
      return (now_ & gamelog::kStateCatchFailed) != 0 ? TouchKind::kPunch : TouchKind::kCatch;
    }
    return std::nullopt;
  }

 private:
  bool grew(std::size_t counter) const {
    return counters_now_[counter] > counters_before_[counter];
  }
  bool began(std::uint32_t bit) const { return (now_ & bit) != 0 && (before_ & bit) == 0; }

  // Versions 1 and 2 have no counters, version 3 none for tackles: their bits must do.
  bool kicked() const {
    if (version_ >= gamelog::RcgVersion::kV3) return grew(kKick);
    return (now_ & gamelog::kStateKick) != 0 && (now_ & gamelog::kStateKickFailed) == 0;
  }
  bool tackled() const {
    return version_ >= gamelog::RcgVersion::kV4 ? grew(kTackle) : began(gamelog::kStateTackle);
  }
  bool caught() const {
    return version_ >= gamelog::RcgVersion::kV3
               ? grew(kCatch)
               : (now_ & gamelog::kStateCatchFailed) == 0 && began(gamelog::kStateCatch);
  }

  std::uint32_t before_;
  std::uint32_t now_;
  const gamelog::Counters& counters_before_;
  const gamelog::Counters& counters_now_;
  gamelog::RcgVersion version_;
};

// The logged velocity is zero where the referee stops the ball in the same step: the displacement
// is not, unless the ball was put elsewhere.
soccer::Vec2 launch_of(const gamelog::MatchRecord& record, std::size_t frame) {
  const soccer::Vec2 moved =
      soccer::Vec2(record.ball_position[frame]) - record.ball_position[frame - 1];
  if (moved.length() <= record.server.ball_speed_max + kPlacedMargin) return moved;
  return soccer::Vec2(record.ball_velocity[frame]) / record.server.ball_decay;
}

// Within play_on the referee drops a ball that got stuck, and a trainer may move it. No mode of the
// log says so, the ball does: it jumps, or stands still at once.
bool was_placed(const gamelog::MatchRecord& record, std::size_t frame) {
  const soccer::Vec2 before = record.ball_velocity[frame - 1];
  const soccer::Vec2 now = record.ball_velocity[frame];
  const double moved =
      soccer::distance(record.ball_position[frame], record.ball_position[frame - 1]);
  return moved > record.server.ball_speed_max + kPlacedMargin ||
         (now == soccer::Vec2{} && before.length() > kStillRolls);
}

// All who touched the ball in the step to `frame`, as one event.
std::optional<Touch> touch_in(const gamelog::MatchRecord& record, std::size_t frame) {
  Touch touch;
  const soccer::Vec2 ball = record.ball_position[frame - 1];
  PerTeam<double> nearest = {std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::max()};
  PerTeam<TouchKind> kinds = {};
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    const auto kind = TouchTest(record, entry).kind();
    if (!kind) continue;
    touch.touchers |= std::uint32_t{1} << slot;
    const std::size_t team = team_of(slot);
    const double away = soccer::distance(record.players.position[entry - gamelog::kSlots], ball);
    if (away >= nearest[team]) continue;
    nearest[team] = away;
    touch.nearest[team] = static_cast<std::int8_t>(slot);
    kinds[team] = *kind;
  }
  if (touch.touchers == 0) return std::nullopt;
  const bool both = touch.nearest[0] != kNobody && touch.nearest[1] != kNobody;
  const std::size_t first = nearest[0] <= nearest[1] ? 0 : 1;
  touch.slot = both ? kNobody : touch.nearest[first];
  touch.kind = kinds[first];
  touch.frame = static_cast<std::uint32_t>(frame);
  touch.contact = ball;
  touch.launch = launch_of(record, frame);
  return touch;
}

void find_phases(Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  std::int32_t phases = 0;
  for (std::size_t i = 0; i < record.frames(); ++i) {
    flow.phase.push_back(phase_of(record.mode[i]));
    bool goes_on = i > 0 && flow.is_live(i) && flow.is_live(i - 1) && follows(record, i);
    if (goes_on && was_placed(record, i)) {
      flow.placed.push_back(static_cast<std::uint32_t>(i));
      goes_on = false;
    }
    if (flow.is_live(i) && !goes_on) ++phases;
    flow.live_phase.push_back(flow.is_live(i) ? phases - 1 : -1);
  }
}

// A goal kick is in play once it has left the penalty area: the touch lies some frames before the
// live phase that it starts.
void attach_goal_kick(Flow& flow, std::size_t frame) {
  if (flow.touches.empty() || flow.phase[frame - 1] != Phase::kSet) return;
  Touch& touch = flow.touches.back();
  if (touch.live_phase >= 0 || flow.phase[touch.frame] != Phase::kSet) return;
  for (std::size_t i = touch.frame; i < frame; ++i) {
    if (flow.record->mode[i] != flow.record->mode[touch.frame]) return;
  }
  touch.live_phase = flow.live_phase[frame];
  flow.owner[frame] = touch.slot;
}

}  // namespace

std::size_t Flow::end_of_play(const Touch& touch) const {
  std::size_t frame = touch.frame;
  const bool ends_here =
      live_phase[frame] != touch.live_phase && live_phase[frame - 1] == touch.live_phase;
  if (ends_here) return frame;
  // The phase that a goal kick starts begins some frames later.
  while (frame < live_phase.size() && live_phase[frame] != touch.live_phase) ++frame;
  while (frame < live_phase.size() && live_phase[frame] == touch.live_phase) ++frame;
  return frame;
}

Flow flow_of(const gamelog::MatchRecord& record) {
  Flow flow;
  flow.record = &record;
  find_phases(flow);
  flow.owner.assign(record.frames(), kNobody);
  for (std::size_t i = 1; i < record.frames(); ++i) {
    if (!follows(record, i)) continue;
    const bool live = flow.is_live(i);
    const bool goes_on = live && flow.live_phase[i] == flow.live_phase[i - 1];
    const bool begins = live && !flow.is_live(i - 1);
    if (goes_on) flow.owner[i] = flow.owner[i - 1];
    auto touch = touch_in(record, i);
    if (touch) {
      // Where the referee put the ball afterwards, the touch is the last of what was before.
      touch->live_phase = flow.live_phase[begins ? i : i - 1];
      if (goes_on || begins) flow.owner[i] = touch->slot;
      flow.touches.push_back(*touch);
    } else if (live && !goes_on) {
      attach_goal_kick(flow, i);
    }
  }
  return flow;
}

const soccer::PlayerType& type_of(const gamelog::MatchRecord& record, std::size_t entry) {
  static const soccer::PlayerType kDefault;
  const int type = record.players.type[entry];
  if (type < 0 || static_cast<std::size_t>(type) >= record.types.size()) return kDefault;
  return record.types[static_cast<std::size_t>(type)];
}

double kickable_radius(const gamelog::MatchRecord& record, std::size_t entry) {
  return type_of(record, entry).kickable_area(record.server.ball_size);
}

}  // namespace cls::analysis
