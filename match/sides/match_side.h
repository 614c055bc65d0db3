// One side of a match: cls agents with a Playmaker, or an external team.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/result/match_end.h"
#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "match/result/speed.h"
#include "match/server/server_output.h"
#include "match/sides/turn_taker.h"
#include "proxy/agent/decision_listener.h"
#include "proxy/connection/agent_statistics.h"
#include "proxy/playmaker/call_watch.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "proxy/playmaker/rpc_listener.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::match {

/// The names of a side.
struct SideIdentity {
  soccer::Side side = soccer::Side::kLeft;  ///< neutral: the trainer
  std::string name;                         ///< team name, or "trainer"
  std::string endpoint;                     ///< as the user wrote it
};

/// The time of a match, for the messages of a side that fails.
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

/// The match as the agents of a side over UDP have seen it.
struct SeenMatch {
  SourceProgress progress;
  std::optional<soccer::Vec2> ball;    ///< its position, if known, in the server's coordinates
  MatchMode mode = MatchMode::kSynch;  ///< that the server told the agents
  bool finished = false;               ///< the match has ended
  bool at_cycle_limit = false;         ///< the first cycle beyond --cycles has begun
};

/// Used by the match's thread only. Use: prepare, join, handshake, play, leave, terminate,
/// wait_gone, result.
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
  /// True when that is over; may wait for it, up to `limit`.
  virtual bool wait_handshake(std::chrono::milliseconds /*limit*/) { return true; }
  /// The beginning of a message about what join() or the handshake waits for.
  virtual std::string waiting_for() const = 0;
  /// A likely mistake when that lasts too long: "; it listens on port 50051, not on 21234".
  virtual std::string timeout_hint() const { return {}; }
  /// The process that a timeout is reported with; nullptr: none.
  virtual const process::Child* awaited_process() const { return nullptr; }

  /// The reply of its Playmaker that the side has waited for longest. At any time.
  virtual std::optional<proxy::AwaitedCall> awaited_reply() const { return std::nullopt; }

  /// All sides have joined and registered: the first cycle follows.
  virtual void begin_play() {}
  /// The match has ended: agents continue without turns until the server or leave() stops them.
  virtual void end_play() {}
  /// nullptr for a side that decides without being told: agents over UDP without --step, and
  /// external teams.
  virtual TurnTaker* turns() { return nullptr; }

  /// The time of the decisions of this side so far; zero for an external team. In lockstep
  /// between turns only.
  virtual TurnTimes turn_times() const { return {}; }
  /// The time of each turn; after wait_gone().
  virtual const proxy::LatencySamples* turn_samples() const { return nullptr; }
  /// Nothing in lockstep, and for an external team.
  virtual std::optional<SeenMatch> seen() const { return std::nullopt; }
  /// Why this side cannot continue, if so.
  virtual std::optional<MatchEnd> failure(const MatchMoment& moment) = 0;
  /// Asked at the end of a match over UDP: a failure that could have been the end itself.
  virtual std::optional<MatchEnd> final_failure(const MatchMoment& /*moment*/) {
    return std::nullopt;
  }
  virtual std::vector<std::string> take_warnings() { return {}; }
  /// The limit of what a side may use of this host that its programs exceed; empty: none. Measured
  /// now and then, or `at_once`.
  virtual std::string excess(bool /*at_once*/) { return {}; }
  /// Cancels calls to the Playmaker.
  virtual void cancel() {}

  /// Says goodbye, or begins to stop.
  virtual void leave() = 0;
  /// Asks all processes of the side to exit.
  virtual void terminate() = 0;
  /// Waits until they are gone; returns what was started.
  virtual std::vector<ProcessResult> wait_gone() = 0;
  /// Expectations of the script of a mock Playmaker that were not met.
  virtual std::vector<std::string> failed_expectations() const { return {}; }
  /// The calls that the side's Playmaker answered with an error; nullptr for a side without one.
  /// After wait_gone().
  virtual const proxy::PlaymakerErrors* errors() const { return nullptr; }
  /// The result of the side. After wait_gone().
  virtual TeamResult result() const = 0;

 private:
  SideIdentity identity_;
};

using Sides = std::vector<std::unique_ptr<MatchSide>>;

inline bool is_trainer(const MatchSide& side) {
  return side.identity().side == soccer::Side::kNeutral;
}
inline bool is_external(const std::unique_ptr<MatchSide>& side) { return side->is_external(); }

}  // namespace cls::match
