// From the referee's memory to the log.
#include "simulator/sessions/keepaway_recorder.h"

#include "simulator/rules/keepaway.h"

namespace cls::simulator {

void KeepawayRecorder::step(const World& world) {
  const KeepawayRule& rule = world.referee.keepaway;
  if (rule.episode == episode_) return;
  if (episode_ == 0) {
    log_.begin(rule.keepers, rule.takers, world.params().keepaway_length,
               world.params().keepaway_width);
  } else {
    using gamelog::KeepawayLoss;
    log_.episode(episode_, start_, world.clock.time,
                 was_taken(rule) ? KeepawayLoss::kTaken : KeepawayLoss::kOutOfBounds);
    start_ = world.clock.time;
  }
  episode_ = rule.episode;
}

}  // namespace cls::simulator
