// Rounds of work between threads.
#include "training/pool/crew.h"

#include <algorithm>
#include <utility>

namespace cls::training {

Crew::Crew(std::size_t count, std::size_t threads,
           std::function<void(std::size_t, std::size_t)> work)
    : count_(count),
      threads_(std::max<std::size_t>(1, std::min(count, threads))),
      work_(std::move(work)) {}

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
  for (unsigned left = unfinished_; left != 0; left = unfinished_) unfinished_.wait(left);
}

void Crew::loop(std::size_t share) {
  unsigned seen = 0;
  for (;;) {
    round_.wait(seen);
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
