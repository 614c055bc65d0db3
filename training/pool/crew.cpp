// Rounds of work between threads.
#include "training/pool/crew.h"

#include <algorithm>
#include <utility>

#include "base/system/parallel.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace cls::training {
namespace {

// About 50 microseconds: a learner's next step mostly comes sooner than a sleeping thread wakes.
constexpr int kSpins = 4000;

void relax() {
#ifdef __SSE2__
  _mm_pause();
#endif
}

// Returns when `value` is no longer `old`: looks for a while, then sleeps.
void wait_for_change(const std::atomic<unsigned>& value, unsigned old, int spins) {
  for (int i = 0; i < spins; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax();
  }
  value.wait(old);
}

// Threads without a processor of their own must not spin: they keep others from working.
int spins_of(std::size_t threads) { return threads <= base::default_jobs() ? kSpins : 0; }

}  // namespace

Crew::Crew(std::size_t count, std::size_t threads,
           std::function<void(std::size_t, std::size_t)> work)
    : count_(count),
      threads_(std::max<std::size_t>(1, std::min(count, threads))),
      work_(std::move(work)),
      spins_(spins_of(threads_)) {}

Crew::~Crew() {
  stopping_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& other : others_) other.join();
}

void Crew::start() {
  for (std::size_t share = others_.size() + 1; share < threads_; ++share) {
    others_.emplace_back([this, share] { loop(share); });
  }
}

void Crew::run() {
  if (threads_ == 1) return work_(0, count_);
  if (others_.size() + 1 < threads_) start();
  unfinished_ = static_cast<unsigned>(threads_ - 1);
  ++round_;
  round_.notify_all();
  work_on(0);
  for (unsigned left = unfinished_; left != 0; left = unfinished_)
    wait_for_change(unfinished_, left, spins_);
}

void Crew::loop(std::size_t share) {
  unsigned seen = 0;
  for (;;) {
    wait_for_change(round_, seen, spins_);
    ++seen;
    if (stopping_) return;
    work_on(share);
    if (--unfinished_ == 0) unfinished_.notify_one();
  }
}

void Crew::work_on(std::size_t share) {
  work_(share * count_ / threads_, (share + 1) * count_ / threads_);
}

}  // namespace cls::training
