// System calls for attributes of threads, which glibc has no functions for.
#include "base/system/time_slice.h"

#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdint>
#include <optional>

namespace cls::base {
namespace {

/// struct sched_attr of <linux/sched/types.h> in its first version.
struct Attributes {
  std::uint32_t size = sizeof(Attributes);
  std::uint32_t policy = 0;
  std::uint64_t flags = 0;
  std::int32_t nice = 0;
  std::uint32_t priority = 0;
  std::uint64_t runtime = 0;  ///< of threads without real-time priority: their slice, ns
  std::uint64_t deadline = 0;
  std::uint64_t period = 0;
};

std::optional<Attributes> attributes_of(pid_t thread) {
  Attributes attributes;
  if (::syscall(SYS_sched_getattr, thread, &attributes, sizeof attributes, 0U) != 0) {
    return std::nullopt;
  }
  if (attributes.policy != SCHED_OTHER) return std::nullopt;
  return attributes;
}

}  // namespace

void set_time_slice(std::chrono::nanoseconds length) {
  auto attributes = attributes_of(0);
  if (!attributes) return;
  attributes->runtime = static_cast<std::uint64_t>(length.count());
  ::syscall(SYS_sched_setattr, 0, &*attributes, 0U);
}

std::chrono::nanoseconds time_slice_of(pid_t thread) {
  const auto attributes = attributes_of(thread);
  return std::chrono::nanoseconds(attributes ? attributes->runtime : 0);
}

}  // namespace cls::base
