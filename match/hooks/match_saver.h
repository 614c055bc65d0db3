// `--save-at`: the replies of a match in a file when a cycle is reached; `--resume`: a check that
// the match is the saved one.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "match/hooks/match_hooks.h"
#include "match/saved/saved_match.h"

namespace cls::match {

class MatchSaver : public MatchHooks {
 public:
  /// Saves after the decisions of the first step at which game time is `cycle` or more.
  MatchSaver(std::filesystem::path file, int cycle, saved::SavedMatch match);

  SideListener* listener(soccer::Side side) override;
  bool after_cycle(const MatchView& view) override;

  /// Why there is no file, or an empty string.
  std::string close() const;

 private:
  class SideSaver : public SideListener {
   public:
    explicit SideSaver(int side) : side_(side) {}
    void on_call(const proxy::RpcCall& call) override;
    bool needs_requests() const override { return false; }
    void move_to(saved::SavedMatch& match);

   private:
    int side_;
    bool saving_ = true;
    std::map<int, std::vector<saved::SavedReply>> replies_;  // by agent
  };

  std::filesystem::path file_;
  int cycle_;
  saved::SavedMatch match_;
  std::int64_t steps_ = 0;
  int last_cycle_ = 0;
  bool saved_ = false;
  std::string error_;
  std::array<SideSaver, 2> sides_ = {SideSaver(1), SideSaver(2)};
};

class ResumeCheck : public MatchHooks {
 public:
  explicit ResumeCheck(std::shared_ptr<const saved::SavedMatch> match) : match_(std::move(match)) {}

  /// Ends the match if it is another one.
  bool after_cycle(const MatchView& view) override;

  /// Why the match cannot be resumed, or an empty string.
  std::string problem() const;

 private:
  std::shared_ptr<const saved::SavedMatch> match_;
  std::int64_t steps_ = 0;
  bool differs_ = false;
};

}  // namespace cls::match
