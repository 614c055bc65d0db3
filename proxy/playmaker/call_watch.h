// Which calls to a Playmaker are awaited, readable while the agents' thread waits for them.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

#include "proto/rpc.h"
#include "proxy/playmaker/playmaker.h"

namespace cls::proxy {

/// A call without a reply so far.
struct AwaitedCall {
  int agent = 0;
  proto::Rpc rpc = proto::Rpc::kRegister;
  std::chrono::steady_clock::duration waited{0};
  int others = 0;  ///< further agents that wait for a reply
};

/// Written by the thread that uses the Playmaker, read by any thread.
class CallWatch {
 public:
  using Clock = std::chrono::steady_clock;

  void begin(int agent, proto::Rpc rpc);
  void end(int agent);

  /// The call that has waited longest; of calls that began in the same cycle, the one with the
  /// lowest agent number, so that the order of messages does not show. Nothing when none is
  /// awaited.
  std::optional<AwaitedCall> oldest() const;

 private:
  struct Call {
    std::atomic<Clock::rep> begun{0};  ///< 0: not awaited
    std::atomic<proto::Rpc> rpc{proto::Rpc::kRegister};
  };
  std::array<Call, kAgentNumbers> calls_;
};

/// Forwards all calls to `inner` and notes them in `watch`; both must outlive the returned object.
std::unique_ptr<Playmaker> watch_calls(Playmaker& inner, CallWatch& watch);

}  // namespace cls::proxy
