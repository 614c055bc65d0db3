// Exit codes and signals in words.
#include "orchestration/process/process_exit.h"

#include <fmt/format.h>

#include <cstring>

namespace cls::orchestration {

std::string signal_name(int number) {
  const char* name = sigabbrev_np(number);
  return name == nullptr ? fmt::format("signal {}", number) : fmt::format("SIG{}", name);
}

std::string to_text(const ProcessExit& exit) {
  return exit.by_signal ? "killed by " + signal_name(exit.number)
                        : fmt::format("exit code {}", exit.number);
}

}  // namespace cls::orchestration
