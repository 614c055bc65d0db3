// Threads that share an atomic index.
#include "base/system/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "base/system/control_group.h"

namespace cls::base {

std::size_t default_jobs() {
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  const int quota = processor_quota().value_or(static_cast<int>(processors));
  return std::min<std::size_t>(processors, static_cast<std::size_t>(quota));
}

void parallel_for(std::size_t count, std::size_t jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void(std::size_t)>& on_done) {
  std::atomic<std::size_t> next = 0;
  std::atomic<std::size_t> done = 0;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      work(i);
      const std::size_t so_far = ++done;
      if (on_done) on_done(so_far);
    }
  };

  std::vector<std::thread> others;
  for (std::size_t i = 1; i < std::min(jobs, count); ++i) others.emplace_back(run);
  run();
  for (std::thread& other : others) other.join();
}

}  // namespace cls::base
