// All calls of a team on one completion queue.
#include "proxy/playmaker/grpc_playmaker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <climits>
#include <utility>
#include <vector>

#include "base/index.h"
#include "proto/grpc_settings.h"
#include "proxy/playmaker/channel_socket.h"
#include "proxy/playmaker/grpc_call.h"
#include "proxy/playmaker/grpc_probe.h"
#include "proxy/playmaker/replies.h"
#include "proxy/playmaker/tls_probe.h"

namespace cls::proxy {
namespace {

using google::protobuf::Message;
using proto::Rpc;

constexpr int kReconnectBackoffMs = 200;
// Poll interval of a waiting thread for cancel().
constexpr int kCancelPollMs = 50;
// The timeout of the call that finds the reason for an unreachable Playmaker.
constexpr RpcTimeout kProbeTimeout{500};
// How often cls probes what answers at the address of a Playmaker that does not connect.
constexpr std::chrono::milliseconds kProbeInterval{1000};

std::shared_ptr<grpc::ChannelCredentials> credentials_for(const GrpcTarget& target) {
  if (target.tls == nullptr) return grpc::InsecureChannelCredentials();
  return grpc::SslCredentials({target.tls->authorities, target.tls->key, target.tls->certificate});
}

grpc::ChannelArguments channel_arguments(const GrpcTarget& target) {
  grpc::ChannelArguments arguments;
  if (target.tls != nullptr && !target.tls->server_name.empty()) {
    arguments.SetSslTargetNameOverride(target.tls->server_name);
  }

  // The minimum backoff stays: it also limits each attempt, and a busy Playmaker accepts slowly.
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, kReconnectBackoffMs);
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, kReconnectBackoffMs / 4);
  // Two teams with the same Playmaker have separate connections.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  if (target.make_socket) connect_over(target.make_socket, arguments);
  // An idle connection, e.g. to a Playmaker in a debugger, must not count as lost.
  arguments.SetInt(GRPC_ARG_CLIENT_IDLE_TIMEOUT_MS, INT_MAX);
  proto::limit_replies(arguments);
  arguments.SetMaxSendMessageSize(-1);
  arguments.SetInt(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, proto::kTeamCallWindow);

  // A retried decision would count twice, and retries need a copy of every request.
  arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  // Playmakers are near: ignore http_proxy of the environment and DNS service records.
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetInt(GRPC_ARG_SERVICE_CONFIG_DISABLE_RESOLUTION, 1);
  return arguments;
}

/// How an agent reaches the Playmaker, and its call.
struct Line {
  std::string name;  ///< of the Playmaker, in messages
  std::shared_ptr<grpc::Channel> channel;
  std::unique_ptr<grpc::GenericStub> stub;
  GrpcCall call;
  bool answered = false;  ///< over the current connection
  bool lost = false;      ///< not yet returned by take_connection_loss()

  void open(std::string to, std::shared_ptr<grpc::Channel> over) {
    name = std::move(to);
    channel = std::move(over);
    stub = std::make_unique<grpc::GenericStub>(channel);
  }
  bool is_connected() const { return channel->GetState(false) == GRPC_CHANNEL_READY; }

  RpcStatus unavailable(const std::string& reason) const {
    return {RpcOutcome::kUnavailable, static_cast<int>(grpc::StatusCode::UNAVAILABLE),
            name + ": " + reason};
  }
};

std::string in_ms(RpcTimeout time) { return std::to_string(time.count()) + " ms"; }

class GrpcPlaymaker : public Playmaker {
 public:
  GrpcPlaymaker(const std::shared_ptr<grpc::Channel>& channel, const std::string& name) {
    proto::apply_grpc_settings();
    for (Line& line : lines_) line.open(name, channel);
  }

  GrpcPlaymaker(const GrpcTarget& target, RpcTimeout team_reply)
      : target_(target), team_reply_(team_reply) {
    proto::apply_grpc_settings();
    const grpc::ChannelArguments arguments = channel_arguments(target);
    const auto credentials = credentials_for(target);
    std::shared_ptr<grpc::Channel> channel;

    for (int agent = kTeamNumber; agent < kAgentNumbers; ++agent) {
      const std::string name = address(target, std::max(agent, 1));
      const bool own = agent == kTeamNumber || name != line_of(agent - 1).name;
      if (own) channel = grpc::CreateCustomChannel(name, credentials, arguments);
      line_of(agent).open(name, channel);
    }
  }

  GrpcPlaymaker(const GrpcPlaymaker&) = delete;
  GrpcPlaymaker& operator=(const GrpcPlaymaker&) = delete;

  ~GrpcPlaymaker() override {
    for (Line& line : lines_) line.call.cancel();
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    if (cancelled()) {
      unsent_.push_back(cancelled_reply(agent, rpc));
      return;
    }
    start(agent, rpc, request, timeout, wait_for_ready);
    ++outstanding_;
  }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    if (is_registration(rpc)) return register_agent(agent, rpc, request, timeout);
    return call_alone(agent, rpc, request, timeout, false);
  }

  // A channel that has lost its connection stays idle until the next call. Its state before a call
  // therefore shows every loss.
  bool take_connection_loss(int agent) override {
    Line& line = line_of(agent);
    if (target_ && line.answered && !line.is_connected()) {
      for (Line& other : lines_) {
        if (other.channel != line.channel) continue;
        other.lost = std::exchange(other.answered, false) || other.lost;
      }
    }
    return std::exchange(line.lost, false);
  }

  std::optional<Reply> next_reply() override {
    if (!unsent_.empty()) return unsent_reply();
    if (outstanding_ == 0) return std::nullopt;
    return completed(wait(true));
  }

  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    if (!unsent_.empty()) return unsent_reply();
    if (outstanding_ == 0) return std::nullopt;
    cancel_if_requested();
    GrpcCall* call = poll(gpr_time_from_micros(timeout.count(), GPR_TIMESPAN));
    if (call == nullptr) return std::nullopt;
    return completed(*call);
  }

  void cancel() override { cancelled_.store(true, std::memory_order_relaxed); }

 private:
  Line& line_of(int agent) { return lines_.at(base::index(agent)); }
  const Line& line_of(int agent) const { return lines_.at(base::index(agent)); }
  void start(int agent, Rpc rpc, const Message& request, RpcTimeout timeout, bool wait_for_ready) {
    Line& line = line_of(agent);
    line.call.start(*line.stub, queue_, agent, rpc, request, timeout, wait_for_ready);
  }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  Reply unsent_reply() {
    Reply reply = std::move(unsent_.back());
    unsent_.pop_back();
    return reply;
  }

  void cancel_if_requested() {
    if (!cancelled()) return;
    for (Line& line : lines_) line.call.cancel();
  }

  // The next call that completes within `timeout`, after finish(); null when none does.
  GrpcCall* poll(gpr_timespec timeout) {
    void* tag = nullptr;
    bool ok = false;
    const auto deadline = gpr_time_add(gpr_now(GPR_CLOCK_MONOTONIC), timeout);
    const auto result = queue_.AsyncNext(&tag, &ok, deadline);
    assert(result != grpc::CompletionQueue::SHUTDOWN);

    if (result != grpc::CompletionQueue::GOT_EVENT) return nullptr;
    auto* call = static_cast<GrpcCall*>(tag);
    call->finish();
    return call;
  }

  // Waits for the next call and finishes it. With `cancellable`, cancel() cancels all calls.
  GrpcCall& wait(bool cancellable) {
    for (;;) {
      if (cancellable) cancel_if_requested();
      GrpcCall* call = poll(gpr_time_from_millis(kCancelPollMs, GPR_TIMESPAN));
      if (call != nullptr) return *call;
    }
  }

  // The goodbye is sent even after cancel(); its timeout bounds it.
  Reply call_alone(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
                   bool wait_for_ready) {
    assert(outstanding_ == 0 && "blocking calls do not mix with outstanding ones");
    const bool is_bye = rpc == Rpc::kSendByeCommand || rpc == Rpc::kUnregisterTeam;
    if (cancelled() && !is_bye) return cancelled_reply(agent, rpc);
    start(agent, rpc, request, timeout, wait_for_ready);
    return reply_of(wait(!is_bye));
  }

  Reply register_agent(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) {
    Reply reply = empty_reply(agent, rpc);
    if (target_ && target_->tls != nullptr) {
      // An invalid certificate stays invalid: fail now instead of waiting for the Playmaker.
      reply.status = tls_status(agent);
      if (!reply.status.ok()) return reply;
    }

    assert(outstanding_ == 0 && "blocking calls do not mix with outstanding ones");
    if (cancelled()) return cancelled_reply(agent, rpc);
    start(agent, rpc, request, timeout, true);
    std::optional<RpcStatus> given_up;
    reply = reply_of(wait_for_registration(agent, rpc, given_up));

    if (given_up && !reply.status.ok()) {
      reply.status = *std::move(given_up);
      return reply;
    }
    if (reply.status.outcome != RpcOutcome::kDeadline) return reply;
    return explain_deadline(agent, rpc, request, timeout);
  }

  // Cancels the call and says why where waiting is useless: a program that does not speak gRPC will
  // not learn it, and one that is connected and leaves RegisterTeam unanswered does not know it.
  GrpcCall& wait_for_registration(int agent, Rpc rpc, std::optional<RpcStatus>& given_up) {
    using Clock = std::chrono::steady_clock;
    Line& line = line_of(agent);
    auto next_probe = Clock::now() + kProbeInterval;
    std::optional<Clock::time_point> connected;
    for (;;) {
      cancel_if_requested();
      GrpcCall* call = poll(gpr_time_from_millis(kCancelPollMs, GPR_TIMESPAN));
      if (call != nullptr) return *call;
      if (cancelled() || given_up || !target_) continue;

      if (line.is_connected()) {
        if (rpc != Rpc::kRegisterTeam || team_reply_ == kNoTimeout) continue;
        if (!connected) connected = Clock::now();
        if (Clock::now() - *connected < team_reply_) continue;
        given_up = no_reply(line, rpc, team_reply_);
        line.call.cancel();
      } else if (Clock::now() >= next_probe) {
        const GrpcProbe probe = probe_grpc(*target_, agent);
        next_probe = Clock::now() + kProbeInterval;
        if (!probe.is_other_protocol || line.is_connected()) continue;
        given_up = line.unavailable(probe.problem);
        line.call.cancel();
      }
    }
  }

  static RpcStatus no_reply(const Line& line, Rpc rpc, RpcTimeout limit) {
    return {RpcOutcome::kDeadline, static_cast<int>(grpc::StatusCode::DEADLINE_EXCEEDED),
            line.name + ": no reply to " + std::string(name(rpc)) + " within " + in_ms(limit)};
  }

  // With wait_for_ready, a deadline without a connection means that the Playmaker is unreachable.
  void report_lost_connection(Reply& reply) const {
    const Line& line = line_of(reply.agent);
    const bool unreachable = target_ && is_registration(reply.rpc) &&
                             reply.status.outcome == RpcOutcome::kDeadline && !line.is_connected();
    if (!unreachable) return;
    reply.status.outcome = RpcOutcome::kUnavailable;
    reply.status.message = line.name + ": connection lost; no reconnection within " +
                           in_ms(std::chrono::duration_cast<RpcTimeout>(reply.latency));
  }

  Reply reply_of(const GrpcCall& call) {
    const Reply& reply = call.reply();
    Line& line = line_of(reply.agent);
    line.answered = line.answered || reply.status.ok();
    // A loss that was noticed while the agent registered needs no second registration.
    if (is_registration(reply.rpc) && reply.status.ok()) line.lost = false;
    return reply;
  }

  Reply completed(const GrpcCall& call) {
    --outstanding_;
    Reply reply = reply_of(call);
    report_lost_connection(reply);
    return reply;
  }

  RpcStatus tls_status(int agent) const {
    const std::string reason = explain_tls_failure(*target_, agent);
    return reason.empty() ? RpcStatus{} : line_of(agent).unavailable(reason);
  }

  // A registration waits for the Playmaker to come up, so an unreachable Playmaker also ends in a
  // deadline. A second call that does not wait distinguishes the two and returns the reason.
  Reply explain_deadline(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) {
    const Line& line = line_of(agent);
    if (line.is_connected()) return failed_reply(agent, rpc, no_reply(line, rpc, timeout));

    const std::string unreachable = "unreachable for " + in_ms(timeout);
    const std::string problem = target_ ? probe_grpc(*target_, agent).problem : std::string();
    if (!problem.empty()) {
      return failed_reply(agent, rpc, line.unavailable(unreachable + ": " + problem));
    }

    Reply reply = call_alone(agent, rpc, request, kProbeTimeout, false);
    if (reply.status.outcome == RpcOutcome::kUnavailable) {
      reply.status.message = line.name + ": " + unreachable + " (" + reply.status.message + ")";
    }
    return reply;
  }

  std::optional<GrpcTarget> target_;  // unset: an existing channel, whose state is not used
  RpcTimeout team_reply_ = kNoTimeout;
  grpc::CompletionQueue queue_;
  std::array<Line, kAgentNumbers> lines_;  // by agent number
  int outstanding_ = 0;
  std::vector<Reply> unsent_;  // to calls begun after cancel()
  std::atomic<bool> cancelled_{false};
};

}  // namespace

std::unique_ptr<Playmaker> make_grpc_playmaker(std::shared_ptr<grpc::Channel> channel,
                                               std::string name) {
  return std::make_unique<GrpcPlaymaker>(channel, name);
}

std::unique_ptr<Playmaker> make_grpc_playmaker(const GrpcTarget& target, RpcTimeout team_reply) {
  return std::make_unique<GrpcPlaymaker>(target, team_reply);
}

}  // namespace cls::proxy
