// How soon the kernel runs a thread that has waited.
#pragma once

#include <sys/types.h>

#include <chrono>

namespace cls::base {

/// From now on the kernel runs the calling thread in slices of this length, 0.1 to 100 ms: with
/// short ones it runs soon after it has waited, before threads that have more to do, also on a busy
/// host. Its share of the processors remains. No effect before Linux 6.12.
void set_time_slice(std::chrono::nanoseconds length);

/// The slice of a thread, by its id; 0: this kernel does not say.
std::chrono::nanoseconds time_slice_of(pid_t thread);

}  // namespace cls::base
