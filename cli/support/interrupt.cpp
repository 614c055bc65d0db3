// Signal handlers that only store the signal number.
#include "cli/support/interrupt.h"

#include <csignal>

namespace cls::cli {
namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free, "required in a signal handler");

void store_signal(int signal) { received.store(signal); }

}  // namespace

const std::atomic<int>& watch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = store_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  return received;
}

ExitCode signal_exit_code(int signal) { return signal == SIGTERM ? kTerminated : kInterrupted; }

}  // namespace cls::cli
