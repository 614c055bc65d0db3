// Hands work to a thread and waits for it.
#include "base/system/worker.h"

#include <pthread.h>
#include <sched.h>

#include <cassert>
#include <ctime>
#include <utility>

#include "base/index.h"

namespace cls::base {
namespace {

double thread_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

double cpu_seconds_of(const std::function<void()>& work) {
  const double begin = thread_cpu_seconds();
  work();
  return thread_cpu_seconds() - begin;
}

}  // namespace

Worker::Worker() : thread_([this] { loop(); }) {}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Worker::start(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    assert(!busy_);
    work_ = std::move(work);
    busy_ = true;
  }
  changed_.notify_all();
}

void Worker::run(const std::function<void()>& work) {
  assert(!busy_);
  cpu_seconds_ += cpu_seconds_of(work);
}

void Worker::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !busy_; });
}

bool Worker::wait_for(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, timeout, [this] { return !busy_; });
}

void Worker::loop() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return busy_ || stopping_; });
    if (!busy_) return;
    lock.unlock();
    const double seconds = cpu_seconds_of(work_);
    lock.lock();
    cpu_seconds_ += seconds;
    busy_ = false;
    changed_.notify_all();
  }
}

void Worker::set_affinity(const std::vector<int>& cpus) {
  if (cpus.empty()) return;
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int cpu : cpus) CPU_SET(index(cpu), &set);
  ::pthread_setaffinity_np(thread_.native_handle(), sizeof set, &set);
}

}  // namespace cls::base
