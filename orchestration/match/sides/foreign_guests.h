// Foreign teams in a match in lockstep: programs that play over UDP on the server of this process,
// and take turns like everybody else.
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/options/match_options.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/sides/foreign_team.h"
#include "simulator/server/lockstep_server.h"
#include "soccer/side.h"

namespace cls::orchestration::match {

/// The `team:` sides of one match, without their coaches. Used on the match's thread.
class ForeignGuests {
 public:
  /// Opens the server to them; nothing is started yet. Null when no side is a foreign team. The
  /// error says what is missing in a team's folder, or who has the port. All arguments must outlive
  /// the guests.
  static base::Result<std::unique_ptr<ForeignGuests>> create(const MatchOptions& options,
                                                             const TeamNames& names,
                                                             simulator::LockstepServer& server,
                                                             process::ProcessHost& host,
                                                             const std::filesystem::path& folder);

  bool has(soccer::Side side) const { return teams_[index(side)] != nullptr; }

  /// Goes on with joining; the error says what cannot be started.
  base::Result<void> join(soccer::Side side);
  bool joined(soccer::Side side) const { return team(side).joined(); }
  /// What is missing, for people.
  std::string waiting_for(soccer::Side side) const { return team(side).waiting_for(); }

  /// Before the match: a cycle, so that nobody takes the server for dead, and a moment for what
  /// comes in.
  void pass_time();

  /// The situation is set up: who is on the pitch now has to stay.
  void begin();
  /// Waits for the answers of this cycle, at most until then; true when all are there.
  bool answered(simulator::LockstepServer::Time deadline);

  /// A team that has lost a player, or whose program ended.
  struct Loss {
    soccer::Side side = soccer::Side::kLeft;
    std::string what;  ///< "player 7 has left", "the process of right player 7 ended: ..."
    std::optional<ProcessFailure> failure;
  };
  std::optional<Loss> loss();

  /// Ends all programs and waits until nothing of them is left.
  void end();
  double cpu_seconds(soccer::Side side) const { return team(side).cpu_seconds(); }
  std::vector<ProcessResult> results() const;

 private:
  explicit ForeignGuests(simulator::LockstepServer& server) : server_(server) {}

  static constexpr std::size_t index(soccer::Side side) {
    return side == soccer::Side::kRight ? 1 : 0;
  }
  void set_kick_off_wait(int cycles);
  void forget_the_past();
  ForeignTeam& team(soccer::Side side) const { return *teams_[index(side)]; }

  simulator::LockstepServer& server_;
  std::array<std::unique_ptr<ForeignTeam>, 2> teams_;
  std::array<bool, soccer::kPlayersOnPitch> plays_{};  ///< was on the pitch when it began
  bool playing_ = false;
};

}  // namespace cls::orchestration::match
