// One agent's calls to its Playmaker: asks for decisions, and makes the agent known again when the
// Playmaker may have forgotten it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "proto/playmaker.pb.h"
#include "proto/rpc.h"
#include "proxy/playmaker/introduction.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// How long a decision may take, and for whom.
struct AskingTime {
  RpcTimeout timeout{10'000};  ///< for everything that a decision takes; kNoTimeout: for ever
  bool server_waits = true;    ///< for the agent's (done): lockstep and synchronous mode
  /// Since a connection was lost, while the server waits: so long the Playmaker may take to come
  /// back; after that, decisions fail at once. The decision's own time is a limit too.
  RpcTimeout reconnect_within{3'000};
};

/// A Playmaker is met anew (Register and all that follows) when the connection to it was lost, when
/// it said UNAVAILABLE, and after three errors in a row, then after twice as many and so on: it may
/// have been restarted behind a connection that was kept. Where the server waits, the decision that
/// meets a lost connection is asked again of the Playmaker that comes back; in real time the
/// hand-shake goes on from cycle to cycle until it is done. Use: ask(), then take() each answer of
/// this agent until it says that it is the decision's.
class Correspondence {
 public:
  /// `decision` is one of the three rpcs that ask with a State.
  Correspondence(int agent, proto::Rpc decision, protos::RegisterRequest who,
                 std::shared_ptr<const MatchParameters> parameters);

  /// The hand-shake before the first decision; blocks. Writes the identity into `state`.
  RpcStatus introduce(Playmaker& playmaker, RpcTimeout timeout, protos::State& state);

  /// Begins one call. `state`, whose register_response is kept right here, must stay as it is until
  /// the decision's answer is taken.
  void ask(Playmaker& playmaker, protos::State& state, const AskingTime& time);

  /// True: `reply` is the decision's answer. False: it belonged to the hand-shake, and another call
  /// was begun.
  bool take(Playmaker& playmaker, Reply& reply);

  /// How often a Playmaker that was lost answered again.
  int reconnects() const { return reconnects_; }
  /// Worth a warning since the last call of this; empty: nothing is.
  std::string take_remark() { return std::exchange(remark_, {}); }

 private:
  using Clock = std::chrono::steady_clock;

  bool has_time() const { return time_.timeout == kNoTimeout || Clock::now() < until_; }
  RpcTimeout time_left() const;
  void begin_decision(Playmaker& playmaker);
  void begin_introduction_call(Playmaker& playmaker);
  void meet_anew();
  bool take_introduction(Playmaker& playmaker, Reply& reply);
  bool take_decision(Playmaker& playmaker, const Reply& reply);

  int agent_;
  proto::Rpc decision_;
  protos::RegisterRequest who_;
  std::shared_ptr<const MatchParameters> parameters_;

  std::optional<Introduction> introduction_;  ///< under way, or to be begun
  bool in_introduction_ = false;              ///< the call in flight belongs to it
  bool met_anew_ = false;                     ///< introduced again, no answer since
  bool asked_again_ = false;                  ///< in this decision
  std::optional<Clock::time_point> lost_since_;
  int errors_ = 0;  ///< in a row since the last answer or introduction
  int errors_borne_;
  int reconnects_ = 0;
  std::string remark_;

  protos::State* state_ = nullptr;
  AskingTime time_;
  Clock::time_point until_;
};

}  // namespace cls::proxy
