// Formats exit codes and signals.
#include "process/process_exit.h"

#include <fmt/format.h>

#include <cstring>

namespace cls::process {
namespace {

// A shell whose command was killed by signal N returns this plus N.
constexpr int kShellSignals = 128;

}  // namespace

std::string signal_name(int number) {
  const char* name = sigabbrev_np(number);
  return name == nullptr ? fmt::format("signal {}", number) : fmt::format("SIG{}", name);
}

std::string to_text(const ProcessExit& exit) {
  if (exit.by_signal) return "killed by " + signal_name(exit.number);
  const int signal = exit.number - kShellSignals;
  const std::string hint = signal > 0 && sigabbrev_np(signal) != nullptr
                               ? fmt::format(" ({} + {})", kShellSignals, signal_name(signal))
                               : "";
  return fmt::format("exit code {}{}", exit.number, hint);
}

}  // namespace cls::process
