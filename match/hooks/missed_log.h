// `missed.jsonl`: the decisions that had no usable reply, for the timeline of `cls watch`.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "match/hooks/side_hooks.h"
#include "viewer/decisions/decision_files.h"

namespace cls::match {

/// A decision without a usable reply.
struct Missed {
  int cycle = 0;
  int stopped = 0;
  soccer::Side side = soccer::Side::kLeft;
  int unum = 0;
  proxy::RpcOutcome reason = proxy::RpcOutcome::kDeadline;
};

/// Collects those of one side.
class MissedOfSide : public SideDecisions {
 public:
  explicit MissedOfSide(soccer::Side side) : side_(side) {}

  void on_decision(const proxy::Decision& decision) override;
  const std::vector<Missed>& missed() const { return missed_; }

 private:
  soccer::Side side_;
  std::vector<Missed> missed_;
};

/// Writes viewer::kMissedFile into the match folder at the end of a match with missed decisions:
/// one JSON object a line, by time, side and number: {"t": 120, "stopped": 0, "side": "left",
/// "unum": 7, "reason": "deadline"}.
class MissedLog : public SideHooks<MissedOfSide> {
 public:
  explicit MissedLog(std::filesystem::path folder)
      : SideHooks({MissedOfSide(soccer::Side::kLeft), MissedOfSide(soccer::Side::kRight)}),
        file_(std::move(folder) / viewer::kMissedFile) {}

  std::string close() override;

 private:
  std::filesystem::path file_;
};

}  // namespace cls::match
