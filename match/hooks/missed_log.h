// `missed.jsonl`: the decisions that had no usable reply, for the timeline of `cls watch`.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "match/hooks/match_hooks.h"
#include "viewer/decisions/decision_files.h"

namespace cls::match {

/// Writes viewer::kMissedFile into the match folder at the end of a match with missed decisions:
/// one JSON object a line, by time, side and number: {"t": 120, "stopped": 0, "side": "left",
/// "unum": 7, "reason": "deadline"}.
class MissedLog : public MatchHooks {
 public:
  explicit MissedLog(std::filesystem::path folder)
      : file_(std::move(folder) / viewer::kMissedFile) {}

  SideListener* listener(soccer::Side side) override;

  /// Writes the file. Returns the error, or an empty string.
  std::string close() const;

 private:
  struct Missed {
    int cycle = 0;
    int stopped = 0;
    soccer::Side side = soccer::Side::kLeft;
    int unum = 0;
    proxy::RpcOutcome reason = proxy::RpcOutcome::kDeadline;
  };

  class SideLog : public SideListener, public proxy::DecisionListener {
   public:
    explicit SideLog(soccer::Side side) : side_(side) {}
    proxy::DecisionListener* decisions() override { return this; }
    bool needs_calls() const override { return false; }
    void on_call(const proxy::RpcCall& /*call*/) override {}
    void on_decision(const proxy::Decision& decision) override;
    const std::vector<Missed>& missed() const { return missed_; }

   private:
    soccer::Side side_;
    std::vector<Missed> missed_;
  };

  std::filesystem::path file_;
  std::array<SideLog, 2> sides_ = {SideLog(soccer::Side::kLeft), SideLog(soccer::Side::kRight)};
};

}  // namespace cls::match
