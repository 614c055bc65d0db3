// Moments of decision.
#include "proxy/connection/decision_timer.h"

namespace cls::proxy {
namespace {

/// Sight comes every so many cycles where it comes with sense_body.
int see_period(soccer::ViewWidth width) {
  switch (width) {
    case soccer::ViewWidth::kNarrow:
      return 1;
    case soccer::ViewWidth::kNormal:
      return 2;
    default:
      return 3;
  }
}

}  // namespace

// Where see messages have times of their own, every cycle may bring one.
bool DecisionTimer::expects_see(soccer::ViewWidth width) const {
  return !synch_see_ || !seen_ || since_see_ >= see_period(width);
}

void DecisionTimer::on_sense_body(Instant arrived, soccer::ViewWidth width) {
  if (open_ && begun_) ++undecided_;
  open_ = true;
  cycle_began_ = arrived;
  ++since_see_;
  if (synchronous_) {
    due_at_ = Instant::max();
    return;
  }
  const auto delay = !expects_see(width) ? delays_.no_see
                     : synch_see_        ? delays_.synch_see
                                         : delays_.see;
  due_at_ = arrived + delay * slow_down_;
}

void DecisionTimer::on_see(Instant arrived) {
  seen_ = true;
  since_see_ = 0;
  if (!synchronous_ && open_ && arrived < due_at_) due_at_ = arrived;
}

void DecisionTimer::on_think(Instant arrived) {
  open_ = true;
  due_at_ = arrived;
}

}  // namespace cls::proxy
