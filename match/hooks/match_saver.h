// `--save-at`: the replies of a match in a file when a cycle is reached; `--resume`: a check that
// the match is the saved one.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "match/hooks/side_hooks.h"
#include "match/saved/saved_match.h"

namespace cls::match {

/// Collects the replies of one side by agent, so that their order does not depend on their arrival.
class RepliesOfSide : public SideListener {
 public:
  explicit RepliesOfSide(soccer::Side side) : side_(side) {}

  void on_call(const proxy::RpcCall& call) override;
  bool needs_requests() const override { return false; }
  void move_to(saved::SavedMatch& match);

 private:
  soccer::Side side_;
  bool saving_ = true;
  std::map<int, std::vector<saved::SavedReply>> replies_;  ///< by agent
};

class MatchSaver : public SideHooks<RepliesOfSide> {
 public:
  /// Saves after the decisions of the first step at which game time is `cycle` or more.
  MatchSaver(std::filesystem::path file, int cycle, saved::SavedMatch match)
      : SideHooks({RepliesOfSide(soccer::Side::kLeft), RepliesOfSide(soccer::Side::kRight)}),
        file_(std::move(file)),
        cycle_(cycle),
        match_(std::move(match)) {}

  bool after_cycle(const MatchView& view) override;

  std::string close() override;

 private:
  std::filesystem::path file_;
  int cycle_;
  saved::SavedMatch match_;
  std::int64_t steps_ = 0;
  int last_cycle_ = 0;
  bool saved_ = false;
  std::string error_;
};

class ResumeCheck : public FolderHooks {
 public:
  explicit ResumeCheck(std::shared_ptr<const saved::SavedMatch> match) : match_(std::move(match)) {}

  /// Ends the match if it is another one.
  bool after_cycle(const MatchView& view) override;

  std::string problem() const override;

 private:
  std::shared_ptr<const saved::SavedMatch> match_;
  std::int64_t steps_ = 0;
  bool differs_ = false;
};

}  // namespace cls::match
