// What a replayed match must reach, and how its figures are printed.
#pragma once

#include <string>
#include <vector>

#include "simulator/replay/log_replay.h"

namespace cls::orchestration::checks {

struct Demand {
  std::string what;
  std::string reached;
  std::string bound;
  bool passed = false;
};

/// Classes of steps appear only where they miss too often, noise where there are enough samples.
std::vector<Demand> demands(const simulator::LogAgreement& agreement);
bool passed(const std::vector<Demand>& demands);

/// A report for people, and the document of `cls check server-log --json`.
std::string to_text(const simulator::LogAgreement& agreement, const std::vector<Demand>& demands);
std::string to_json(const simulator::LogAgreement& agreement, const std::vector<Demand>& demands);

}  // namespace cls::orchestration::checks
