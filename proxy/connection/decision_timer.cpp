// Due times of decisions.
#include "proxy/connection/decision_timer.h"

namespace cls::proxy {
namespace {

/// Cycles between see messages in synchronous see mode.
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

// Without synchronous see, a see message may arrive in every cycle.
bool DecisionTimer::expects_see(soccer::ViewWidth width) const {
  return !synch_see_ || !seen_ || since_see_ >= see_period(width);
}

void DecisionTimer::on_sense_body(Instant received_at, soccer::ViewWidth width) {
  if (open_ && begun_) ++undecided_;
  open_ = true;
  cycle_began_ = received_at;
  ++since_see_;

  if (synchronous_) {
    due_at_ = Instant::max();
    return;
  }
  const auto delay = !expects_see(width) ? delays_.no_see
                     : synch_see_        ? delays_.synch_see
                                         : delays_.see;
  due_at_ = received_at + delay * slow_down_;
}

void DecisionTimer::on_see(Instant received_at) {
  seen_ = true;
  since_see_ = 0;
  if (!synchronous_ && open_ && received_at < due_at_) due_at_ = received_at;
}

void DecisionTimer::on_think(Instant received_at) {
  open_ = true;
  due_at_ = received_at;
}

}  // namespace cls::proxy
