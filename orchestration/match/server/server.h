// The soccer server of a match: in this process (EmbeddedServer) or over UDP (ExternalServer).
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "orchestration/match/result/event_recorder.h"
#include "orchestration/match/result/match_end.h"
#include "orchestration/match/result/match_observer.h"
#include "orchestration/match/result/match_result.h"
#include "orchestration/match/server/server_output.h"
#include "simulator/world/event.h"
#include "simulator/world/world.h"

namespace cls::orchestration::match {

/// What the agents of one cls team have seen of the match.
struct AgentProgress {
  std::string team;
  SourceProgress progress;
};

/// Used by the match's thread only.
class Server {
 public:
  virtual ~Server() = default;

  /// True when step() advances the game, after all sides have ended their turn. False when the
  /// server advances without the match.
  virtual bool lockstep() const = 0;

  /// Starts the server and waits until clients can connect, as long as `keep_waiting` returns true.
  /// Returns why the server cannot take part.
  virtual std::optional<MatchEnd> start(const std::function<bool()>& keep_waiting) = 0;
  /// What start() waits for, as the beginning of a message.
  virtual std::string waiting_for() const = 0;
  /// Where monitors can connect, if that was asked for: "127.0.0.1:6000".
  virtual std::string monitor_address() const { return {}; }
  /// The server as a child process; nullptr when cls did not start it.
  virtual const process::Child* child() const { return nullptr; }

  /// Lets a short time pass while sides join.
  virtual void wait_for_clients() = 0;
  /// Teams and players that have connected, and problems that the server reported.
  virtual ServerStatus status() const = 0;
  /// Uniform number of a player of this external team whose connection was lost in play; always
  /// nothing on a server that does not report it.
  virtual std::optional<int> lost_player(soccer::Side /*side*/) { return std::nullopt; }
  /// True when lost_player() reports losses.
  virtual bool reports_lost_players() const { return false; }

  /// All sides have joined: the match begins. `arrange` may change the world of a server in this
  /// process first.
  using Arrange = std::function<void(simulator::World&, simulator::Events&)>;
  virtual void begin_play(const std::vector<Arrange>& arrange) = 0;
  /// Advances by one step in lockstep; otherwise waits for a poll interval and reads what is new.
  virtual void step() = 0;
  /// True when all external clients have ended their turn; waits for them up to `limit`.
  virtual bool turn_done(std::chrono::milliseconds /*limit*/) { return true; }
  virtual SourceProgress progress() const = 0;
  /// The world after the last step; nullptr for a server outside this process.
  virtual const simulator::World* world() const { return nullptr; }
  /// How long a healthy match may show no progress.
  virtual std::chrono::milliseconds quiet_time() const { return {}; }
  /// True at the end of the game or at the cycle limit.
  virtual bool finished() const = 0;
  /// Why the server ended before the match, if it did.
  virtual std::optional<MatchEnd> failure(bool playing) = 0;

  /// How the match leaves the server.
  enum class FinalState {
    kOver,     ///< the match is over: the server exits
    kHeld,     ///< the clients hold it at the cycle limit
    kRunning,  ///< it would continue
  };
  /// Completes its logs or shuts down. A signal shortens the wait for its exit.
  virtual void finish(FinalState state, const std::atomic<int>& signal) = 0;
  /// Waits until no process is left; returns what cls had started.
  virtual std::vector<ProcessResult> wait_gone() { return {}; }
  /// Fills in the score and whatever else only the server knows. After wait_gone().
  virtual void add_result(MatchResult& result, const std::vector<AgentProgress>& agents) const = 0;
};

}  // namespace cls::orchestration::match
