// Checks of a replayed match and their reports.
#pragma once

#include <string>
#include <vector>

#include "simulator/replay/log_replay.h"

namespace cls::checks {

struct LogCheck {
  std::string what;
  std::string reached;
  std::string bound;
  bool passed = false;
};

/// Contains classes of steps only if they miss too often, and noise only with enough samples.
std::vector<LogCheck> log_checks(const simulator::LogAgreement& agreement);
bool passed(const std::vector<LogCheck>& log_checks);

/// A text report, and the document of `cls check server-log --json`.
std::string to_text(const simulator::LogAgreement& agreement,
                    const std::vector<LogCheck>& log_checks);
std::string to_json(const simulator::LogAgreement& agreement,
                    const std::vector<LogCheck>& log_checks);

}  // namespace cls::checks
