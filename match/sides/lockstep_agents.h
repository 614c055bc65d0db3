// A cls team on the embedded server in this process: it decides when the match says so.
#pragma once

#include <chrono>
#include <optional>

#include "match/server/embedded_server.h"
#include "match/sides/agent_side.h"

namespace cls::match {

/// Handshake, turns and goodbye run on the side's worker; between them the team is the match's.
class LockstepAgents : public AgentSide, private TurnTaker {
 public:
  /// `server` must outlive the side.
  LockstepAgents(AgentParts parts, EmbeddedServer& server)
      : AgentSide(std::move(parts)), server_(server) {}

  /// Turns are taken on the thread of the match, while other sides use their own. Only for a
  /// Playmaker that decides in function calls: no other ends a turn in a known time.
  void take_turns_on_match_thread() { on_match_thread_ = true; }

  std::optional<MatchEnd> join(const ServerStatus& server,
                               const std::vector<std::string>& others) override;
  bool joined() const override { return joined_; }
  void begin_handshake() override;
  bool wait_handshake(std::chrono::milliseconds limit) override { return wait_work(limit); }
  std::string waiting_for() const override { return no_answer(); }
  void begin_play() override { end_listening(); }
  TurnTaker* turns() override { return this; }
  std::vector<std::string> take_warnings() override { return team().take_warnings(); }
  void leave() override;
  void terminate() override;

 private:
  void begin_turn(int cycle) override;
  void take_turn() override;
  bool wait_turn(std::chrono::milliseconds limit) override { return wait_work(limit); }
  void end_turn() override;

  base::Result<void> connect();
  /// Waits until the worker no longer uses the team; false after `limit`.
  bool wait_work(std::chrono::milliseconds limit);
  std::optional<MatchEnd> agent_failure(const MatchMoment& moment) override;

  EmbeddedServer& server_;
  bool joined_ = false;
  bool on_match_thread_ = false;
  bool busy_ = false;       ///< the worker uses the team, or take_turn() will
  bool turn_over_ = false;  ///< a turn has ended whose missed decisions were not checked yet
  std::optional<MatchEnd> failed_handshake_;
};

}  // namespace cls::match
