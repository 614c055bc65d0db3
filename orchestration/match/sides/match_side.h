// One side of a match: cls agents with a Playmaker, or an external team.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/match/result/match_end.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/result/speed.h"
#include "orchestration/match/server/server_output.h"
#include "proxy/agent/decision_listener.h"
#include "proxy/connection/agent_statistics.h"
#include "proxy/playmaker/call_watch.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "proxy/playmaker/rpc_listener.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::orchestration::match {

/// Which side of the match this is.
struct SideIdentity {
  soccer::Side side = soccer::Side::kLeft;  ///< neutral: the trainer
  std::string name;                         ///< team name, or "trainer"
  std::string endpoint;                     ///< as the user wrote it
};

/// Where the match is, for the messages of a side that fails.
struct MatchMoment {
  bool playing = false;  ///< false: before the first cycle
  int cycle = 0;
};

/// Hears all calls of one side to its Playmaker, cycle by cycle. Called on the thread that uses the
/// Playmaker at that time.
class SideListener : public proxy::RpcListener {
 public:
  /// Hears the decisions of the side's players; nullptr: none.
  virtual proxy::DecisionListener* decisions() { return nullptr; }
  /// False: on_call() is never called.
  virtual bool needs_calls() const { return true; }
  /// Before the calls of a cycle.
  virtual void begin_cycle(int /*cycle*/) {}
  /// After the calls of a cycle, and after the handshake.
  virtual void end_cycle() {}
};

/// Used by the match's thread only. Use: prepare, join, handshake, turns, leave, terminate,
/// wait_gone, add_result.
class MatchSide {
 public:
  explicit MatchSide(SideIdentity identity) : identity_(std::move(identity)) {}
  virtual ~MatchSide() = default;
  MatchSide(const MatchSide&) = delete;
  MatchSide& operator=(const MatchSide&) = delete;

  const SideIdentity& identity() const { return identity_; }
  /// "brain (localhost:50051)".
  std::string who() const { return identity_.name + " (" + identity_.endpoint + ")"; }
  /// True for a team whose agents are programs of its own.
  virtual bool is_external() const { return false; }
  /// The name that the team plays under.
  virtual std::string team_name() const { return identity_.name; }

  /// Adds a listener, which must outlive the side. Before join(). False for a side without
  /// Playmaker.
  virtual bool listen(SideListener& /*listener*/) { return false; }

  /// True when the side's own programs are ready to be asked.
  virtual bool prepared() { return true; }
  /// Continues with joining. `server` is what the server has reported, `others` the names of the
  /// teams that joined before. Returns why the side cannot take part.
  virtual std::optional<MatchEnd> join(const ServerStatus& server,
                                       const std::vector<std::string>& others) = 0;
  virtual bool joined() const = 0;
  /// Introduces the agents to their Playmaker.
  virtual void begin_handshake() {}
  virtual bool handshake_done() { return true; }
  /// What join() or the handshake waits for, as the beginning of a message.
  virtual std::string waiting_for() const = 0;
  /// What may be wrong when that lasts too long: "; it listens on port 50051, not on 21234".
  virtual std::string timeout_hint() const { return {}; }
  /// The process that a timeout is reported with; nullptr: none.
  virtual const process::Child* awaited_process() const { return nullptr; }

  /// The reply of its Playmaker that the side has waited for longest. At any time.
  virtual std::optional<proxy::AwaitedCall> awaited_reply() const { return std::nullopt; }

  /// All sides have joined and registered: the first cycle follows.
  virtual void begin_play() {}
  /// The match has ended: agents continue without turns until the server or leave() stops them.
  virtual void end_play() {}
  /// True for a side that decides only after begin_turn(): always in lockstep, and over UDP with
  /// --step.
  virtual bool takes_turns() const { return false; }
  /// True while such a side waits for begin_turn().
  virtual bool at_turn() const { return false; }
  /// Lets the agents decide about the current cycle.
  virtual void begin_turn(int /*cycle*/) {}
  /// Takes a begun turn that has no thread of its own; after begin_turn() of all sides.
  virtual void take_turn() {}
  virtual bool turn_done() { return true; }
  virtual void end_turn() {}

  /// How long the decisions of this side have taken so far; zero for an external team. In lockstep
  /// between turns only.
  virtual TurnTimes turn_times() const { return {}; }
  /// The time of each turn; after wait_gone().
  virtual const proxy::LatencySamples* turn_samples() const { return nullptr; }
  /// What the agents have seen of the match; nothing for an external team.
  virtual std::optional<SourceProgress> progress() const { return std::nullopt; }
  /// The ball's position if the agents know it, in the server's coordinates.
  virtual std::optional<soccer::Vec2> ball() const { return std::nullopt; }
  /// The mode that the server told the agents; nothing when the match decides.
  virtual std::optional<MatchMode> mode() const { return std::nullopt; }
  /// True when the side has seen the match end.
  virtual bool finished() const { return false; }
  /// True when the side has seen the first cycle beyond --cycles.
  virtual bool at_cycle_limit() const { return false; }
  /// Why this side cannot continue, if so.
  virtual std::optional<MatchEnd> failure(const MatchMoment& moment) = 0;
  /// The same at the end of the match, for a failure that could have been the end itself.
  virtual std::optional<MatchEnd> final_failure(const MatchMoment& /*moment*/) {
    return std::nullopt;
  }
  virtual std::vector<std::string> take_warnings() { return {}; }
  /// Cancels calls to the Playmaker.
  virtual void cancel() {}

  /// Says goodbye, or begins to stop.
  virtual void leave() = 0;
  /// Asks all processes of the side to exit.
  virtual void terminate() = 0;
  /// Waits until they are gone; returns what was started.
  virtual std::vector<ProcessResult> wait_gone() = 0;
  /// What the script of a mock Playmaker expected and did not get.
  virtual std::vector<std::string> failed_expectations() const { return {}; }
  /// What the side's Playmaker answered with an error; nullptr for a side without one. After
  /// wait_gone().
  virtual const proxy::PlaymakerErrors* errors() const { return nullptr; }
  /// What this side did. After wait_gone().
  virtual TeamResult result() const = 0;

 private:
  SideIdentity identity_;
};

}  // namespace cls::orchestration::match
