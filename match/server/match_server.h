// The soccer server of a match: in this process (EmbeddedServer) or over UDP (ExternalServer).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "match/result/event_recorder.h"
#include "match/result/match_end.h"
#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "match/server/server_output.h"

namespace cls::match {

/// The match as the agents of one cls team have seen it.
struct AgentProgress {
  std::string team;
  SourceProgress progress;
};

/// A side whose programs have reached for the other side.
struct Intruder {
  soccer::Side side = soccer::Side::kLeft;
  std::string evidence;  ///< "programs of the left side hold 23 connections to the soccer server"
};

/// The server as a match sees it; its loop knows which one it advances. Used by the match's
/// thread only.
class Server {
 public:
  virtual ~Server() = default;

  /// Starts the server and waits until clients can connect, as long as `keep_waiting` returns true.
  /// Returns why the server cannot take part.
  virtual std::optional<MatchEnd> start(const std::function<bool()>& keep_waiting) = 0;
  /// The beginning of a message about what start() waits for.
  virtual std::string waiting_for() const = 0;
  /// The address for monitors, if that was asked for: "127.0.0.1:6000".
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

  /// True for a server that accepts the clients of a side from its own programs only.
  virtual bool binds_clients() const = 0;
  /// True if only programs of this external side can take the places of its agents.
  virtual bool keeps_places(soccer::Side /*side*/) const { return binds_clients(); }
  /// On a server that accepts any client: a side that has connected more of them than it has.
  virtual std::optional<Intruder> intruder() { return std::nullopt; }

  virtual SourceProgress progress() const = 0;
  /// True at the end of the game or at the cycle limit.
  virtual bool finished() const = 0;
  /// Lines about its clients since the last call, of the server or of the match.
  virtual std::vector<std::string> take_warnings() { return {}; }
  /// Why the server ended before the match, if it did.
  virtual std::optional<MatchEnd> failure(bool playing) = 0;

  /// Waits until no process is left; returns what cls had started.
  virtual std::vector<ProcessResult> wait_gone() { return {}; }
  /// Fills in the score and whatever else only the server knows. After wait_gone().
  virtual void add_result(MatchResult& result, const std::vector<AgentProgress>& agents) const = 0;
};

}  // namespace cls::match
