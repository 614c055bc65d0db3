// A match over UDP, in real time or synchronous: for clients that are programs of their own.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "base/result.h"
#include "simulator/server/step_clock.h"
#include "simulator/sessions/match_server.h"

namespace cls::simulator {

struct UdpConfig {
  MatchConfig match;  ///< server.synch_mode decides how time runs

  std::string address = "127.0.0.1";  ///< to listen on, as a number
  int port = 6000;                    ///< of players and monitors; 0: a free one
  int trainer_port = 0;
  int coach_port = 0;  ///< of online coaches

  // In synchronous mode:

  /// How long a cycle waits for (done) of everybody who was asked to think.
  std::chrono::milliseconds max_wait{1250};
  /// More cycles than this without some answer, in a row and after the start, end the match.
  int max_missed = 20;
  /// Before each cycle until time runs, so that clients have time to come.
  std::chrono::milliseconds pause_before_start{50};
};

class UdpNetwork;

/// Why a match over UDP ended.
enum class UdpEnd : std::uint8_t {
  kFinished,    ///< time over in auto mode, or the cycle limit
  kStopped,     ///< it was asked to
  kUnanswered,  ///< too many cycles without an answer
};

/// What is worth telling whoever runs the server.
struct UdpNotice {
  enum class Kind : std::uint8_t {
    kConnected,  ///< for the first time or again
    kDisconnected,
    kMissedCycle,  ///< after the start, somebody did not answer in time
  };

  Kind kind = Kind::kConnected;
  ClientId client = kNobody;  ///< whose connection it is
  int version = 0;            ///< kConnected: of the client
};

/// Listens where rcssserver does and answers each client from a port of its own (protocol 1.1).
/// In synchronous mode, what clients send in a cycle is executed when all are done, in an order
/// drawn from the seed; coaches and the trainer are asked with the players, and in a few cycles,
/// drawn too, only after that. So a match depends on when clients join
/// and on what they send, not on who is faster. In real time, a step is made every simulator_step
/// times slow_down_factor, and what has arrived is executed every recv_step, the last time right
/// before the step (protocol 8.1). Sockets are used on the calling thread only.
class UdpServer {
 public:
  /// The error names the address that cannot be used, or the parameter that makes no match.
  static base::Result<std::unique_ptr<UdpServer>> open(UdpConfig config);
  ~UdpServer();

  /// The port to connect to.
  int port(Door door = Door::kGame) const;

  /// What the side's online coach calls itself; empty if there is none or it does not.
  const std::string& coach_name(Side side) const { return match_->coaches().name(side); }

  /// See MatchServer::record.
  void record(const LogSinks& sinks) { match_->record(sinks); }

  /// Called on the thread of run() whenever there is something to tell. Must return quickly.
  using OnNotice = std::function<void(const UdpNotice&)>;
  void on_notice(OnNotice tell) { tell_ = std::move(tell); }

  /// Called on the thread of run() after every step, before the senses of it. Must return quickly.
  using OnStep = std::function<void(const World&)>;
  void on_step(OnStep look) { look_ = std::move(look); }

  /// Plays to the end and writes the result into the logs. After time over in auto mode the clients
  /// are given game_over_wait cycles to leave; without auto mode only `stop` or the cycle limit end
  /// it. `stop` may be set by another thread or a signal.
  UdpEnd run(const std::atomic<bool>& stop);

  /// In real time: how punctual the steps were. Not while run() runs.
  StepClock::Lateness lateness() const { return lateness_; }

  /// Cycles in which some player did not answer in time.
  std::int64_t missed_cycles() const;

  const World& world() const;

 private:
  UdpServer(UdpConfig config, std::unique_ptr<MatchServer> match);

  UdpEnd run_synchronous(const std::atomic<bool>& stop);
  UdpEnd run_in_real_time(const std::atomic<bool>& stop);
  bool run_cycle(const std::atomic<bool>& stop);
  bool wait_for_answers(const std::atomic<bool>& stop, const std::function<bool()>& enough);
  void receive_until(StepClock::Time next_step, int step_ms, const std::atomic<bool>& stop);
  void make_step();
  void execute();
  bool is_over() const;
  void tell_connections();
  void tell(UdpNotice::Kind kind, ClientId client, int version = 0) {
    if (tell_) tell_({kind, client, version});
  }

  UdpConfig config_;
  std::unique_ptr<MatchServer> match_;
  std::unique_ptr<UdpNetwork> network_;
  OnNotice tell_;
  OnStep look_;
  std::array<const Connection*, MatchServer::kMostClients> told_{};  ///< what was told of
  std::int64_t missed_cycles_ = 0;
  int missed_in_a_row_ = 0;
  StepClock::Lateness lateness_;
};

}  // namespace cls::simulator
