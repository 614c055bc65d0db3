// Signal handlers that only take a note.
#include "cli/support/interrupt.h"

#include <csignal>

namespace cls::cli {
namespace {

std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only use these");

void note(int signal) { noted.store(signal); }

}  // namespace

const std::atomic<int>& watch_interrupts() {
  struct sigaction action = {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  return noted;
}

}  // namespace cls::cli
