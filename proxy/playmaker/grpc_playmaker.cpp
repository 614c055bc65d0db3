// Calls in flight together on one completion queue.
#include "proxy/playmaker/grpc_playmaker.h"

#include <grpc/support/log.h>

#include <array>
#include <atomic>
#include <cassert>
#include <climits>
#include <cstdlib>
#include <utility>
#include <vector>

#include "proxy/playmaker/grpc_call.h"
#include "proxy/playmaker/tls_probe.h"

namespace cls::proxy {
namespace {

constexpr int kReconnectBackoffMs = 200;
// How often a waiting thread looks whether cancel() was called.
constexpr int kCancelCheckMs = 50;
// For finding out why a Playmaker cannot be reached.
constexpr RpcTimeout kProbeTimeout{500};

std::shared_ptr<grpc::ChannelCredentials> credentials_for(const GrpcTarget& target) {
  if (target.tls == nullptr) return grpc::InsecureChannelCredentials();
  // gRPC writes a line to stderr for every handshake that fails; tls_trouble() says it once.
  if (std::getenv("GRPC_VERBOSITY") == nullptr) gpr_set_log_function([](gpr_log_func_args*) {});
  return grpc::SslCredentials({target.tls->authorities, target.tls->key, target.tls->certificate});
}

grpc::ChannelArguments channel_arguments(const GrpcTarget& target) {
  grpc::ChannelArguments arguments;
  if (target.tls != nullptr && !target.tls->server_name.empty()) {
    arguments.SetSslTargetNameOverride(target.tls->server_name);
  }
  // Not the minimum: it is also how long an attempt may take, and a busy Playmaker takes long.
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, kReconnectBackoffMs);
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, kReconnectBackoffMs / 4);
  // Two teams that ask the same Playmaker keep a connection each.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  // A connection at rest, as when the Playmaker is looked at in a debugger, must not look lost.
  arguments.SetInt(GRPC_ARG_CLIENT_IDLE_TIMEOUT_MS, INT_MAX);
  arguments.SetMaxReceiveMessageSize(-1);
  arguments.SetMaxSendMessageSize(-1);
  // A decision asked twice would count twice; and retries keep copies of every request.
  arguments.SetInt(GRPC_ARG_ENABLE_RETRIES, 0);
  // Playmakers stand near; the environment's http_proxy and DNS service records are not for them.
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetInt(GRPC_ARG_SERVICE_CONFIG_DISABLE_RESOLUTION, 1);
  return arguments;
}

class GrpcPlaymaker : public Playmaker {
 public:
  GrpcPlaymaker(std::shared_ptr<grpc::Channel> channel, std::string name) : channels_{} {
    channels_.fill(std::move(channel));
    names_.fill(std::move(name));
    make_stubs();
  }

  explicit GrpcPlaymaker(const GrpcTarget& target) : target_(target) {
    const grpc::ChannelArguments arguments = channel_arguments(target);
    const auto credentials = credentials_for(target);
    for (int agent = 1; agent < kAgentNumbers; ++agent) {
      const auto i = static_cast<std::size_t>(agent);
      names_[i] = address(target, agent);
      const bool own = agent == 1 || names_[i] != names_[i - 1];
      channels_[i] =
          own ? grpc::CreateCustomChannel(names_[i], credentials, arguments) : channels_[i - 1];
    }
    make_stubs();
  }

  GrpcPlaymaker(const GrpcPlaymaker&) = delete;
  GrpcPlaymaker& operator=(const GrpcPlaymaker&) = delete;

  ~GrpcPlaymaker() override {
    for (GrpcCall& call : calls_) call.cancel();
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  RpcStatus register_agent(int agent, const protos::RegisterRequest& request, RpcTimeout timeout,
                           protos::RegisterResponse& response) override {
    if (target_ && target_->tls != nullptr) {
      // A certificate that is no good will be none later: no need to wait.
      RpcStatus status = tls_status(agent);
      if (!status.ok()) return status;
    }
    RpcStatus status = ask(agent, "Register", request, GrpcCall::Answer::kRegister, timeout, true);
    if (status.outcome == RpcOutcome::kDeadline) status = explain_silence(agent, request, timeout);
    if (status.ok()) {
      response = static_cast<const protos::RegisterResponse&>(*call_of(agent).message());
    }
    return status;
  }

  RpcStatus send_server_params(int agent, const protos::ServerParam& params,
                               RpcTimeout timeout) override {
    return ask(agent, "SendServerParams", params, GrpcCall::Answer::kEmpty, timeout);
  }
  RpcStatus send_player_params(int agent, const protos::PlayerParam& params,
                               RpcTimeout timeout) override {
    return ask(agent, "SendPlayerParams", params, GrpcCall::Answer::kEmpty, timeout);
  }
  RpcStatus send_player_type(int agent, const protos::PlayerType& type,
                             RpcTimeout timeout) override {
    return ask(agent, "SendPlayerType", type, GrpcCall::Answer::kEmpty, timeout);
  }
  RpcStatus send_init_message(int agent, const protos::InitMessage& message,
                              RpcTimeout timeout) override {
    return ask(agent, "SendInitMessage", message, GrpcCall::Answer::kEmpty, timeout);
  }
  RpcStatus send_bye(int agent, const protos::RegisterResponse& identity,
                     RpcTimeout timeout) override {
    // Said even after cancel(); its timeout bounds it.
    start_alone(agent, "SendByeCommand", identity, GrpcCall::Answer::kEmpty, timeout, false);
    return wait(false).status();
  }

  void begin_player_actions(int agent, const protos::State& state, RpcTimeout timeout) override {
    begin(agent, "GetPlayerActions", state, GrpcCall::Answer::kPlayer, timeout);
  }
  void begin_coach_actions(int agent, const protos::State& state, RpcTimeout timeout) override {
    begin(agent, "GetCoachActions", state, GrpcCall::Answer::kCoach, timeout);
  }
  void begin_trainer_actions(int agent, const protos::State& state, RpcTimeout timeout) override {
    begin(agent, "GetTrainerActions", state, GrpcCall::Answer::kTrainer, timeout);
  }
  void begin_best_planner_action(int agent, const protos::BestPlannerActionRequest& request,
                                 RpcTimeout timeout) override {
    begin(agent, "GetBestPlannerAction", request, GrpcCall::Answer::kPlanner, timeout);
  }

  void begin_introduction(int agent, proto::Rpc rpc, const google::protobuf::Message& request,
                          RpcTimeout timeout, bool wait) override {
    const bool registers = rpc == proto::Rpc::kRegister;
    begin(agent, name_of(rpc), request,
          registers ? GrpcCall::Answer::kRegister : GrpcCall::Answer::kEmpty, timeout, wait);
  }

  // A channel that has lost its connection is idle until somebody asks; only then does it connect
  // again. So its state, looked at before a call, tells of every loss.
  bool take_lost_connection(int agent) override {
    const auto i = static_cast<std::size_t>(agent);
    if (target_ && answered_[i] && channels_[i]->GetState(false) != GRPC_CHANNEL_READY) {
      for (std::size_t other = 1; other < channels_.size(); ++other) {
        if (channels_[other] != channels_[i]) continue;
        lost_[other] = std::exchange(answered_[other], false) || lost_[other];
      }
    }
    return std::exchange(lost_[i], false);
  }

  std::optional<Reply> next_reply() override {
    if (!never_asked_.empty()) return never_asked_reply();
    if (outstanding_ == 0) return std::nullopt;
    GrpcCall& call = wait(true);
    --outstanding_;
    return reply_of(call);
  }

  std::optional<Reply> next_reply_within(std::chrono::microseconds longest) override {
    if (!never_asked_.empty()) return never_asked_reply();
    if (outstanding_ == 0) return std::nullopt;
    cancel_if_asked();
    GrpcCall* call = poll(gpr_time_from_micros(longest.count(), GPR_TIMESPAN));
    if (call == nullptr) return std::nullopt;
    --outstanding_;
    return reply_of(*call);
  }

  void cancel() override { cancelled_.store(true, std::memory_order_relaxed); }

 private:
  void make_stubs() {
    for (std::size_t i = 1; i < stubs_.size(); ++i) {
      stubs_[i] = std::make_unique<grpc::GenericStub>(channels_[i]);
    }
  }

  GrpcCall& call_of(int agent) { return calls_.at(static_cast<std::size_t>(agent)); }
  grpc::GenericStub& stub_of(int agent) { return *stubs_.at(static_cast<std::size_t>(agent)); }
  int agent_of(const GrpcCall& call) const { return static_cast<int>(&call - calls_.data()); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  static RpcStatus cancelled_status() {
    return {RpcOutcome::kCancelled, static_cast<int>(grpc::StatusCode::CANCELLED), "cancelled"};
  }

  Reply never_asked_reply() {
    Reply reply;
    reply.agent = never_asked_.back();
    reply.status = cancelled_status();
    never_asked_.pop_back();
    return reply;
  }

  void cancel_if_asked() {
    if (!cancelled()) return;
    for (GrpcCall& call : calls_) call.cancel();
  }

  // The next call that is done within `longest`, finished; null when none is.
  GrpcCall* poll(gpr_timespec longest) {
    void* tag = nullptr;
    bool ok = false;
    const auto until = gpr_time_add(gpr_now(GPR_CLOCK_MONOTONIC), longest);
    const auto result = queue_.AsyncNext(&tag, &ok, until);
    assert(result != grpc::CompletionQueue::SHUTDOWN);
    if (result != grpc::CompletionQueue::GOT_EVENT) return nullptr;
    auto* call = static_cast<GrpcCall*>(tag);
    call->finish();
    return call;
  }

  // The next call that is done, finished. With `cancellable`, cancel() ends all that are in flight.
  GrpcCall& wait(bool cancellable) {
    for (;;) {
      if (cancellable) cancel_if_asked();
      GrpcCall* call = poll(gpr_time_from_millis(kCancelCheckMs, GPR_TIMESPAN));
      if (call != nullptr) return *call;
    }
  }

  void start_alone(int agent, const char* method, const google::protobuf::MessageLite& request,
                   GrpcCall::Answer answer, RpcTimeout timeout, bool wait_for_ready) {
    assert(outstanding_ == 0 && "the hand-shake does not mix with decisions");
    call_of(agent).start(stub_of(agent), queue_, method, request, answer, timeout, wait_for_ready);
  }

  RpcStatus ask(int agent, const char* method, const google::protobuf::MessageLite& request,
                GrpcCall::Answer answer, RpcTimeout timeout, bool wait_for_ready = false) {
    if (cancelled()) return cancelled_status();
    start_alone(agent, method, request, answer, timeout, wait_for_ready);
    const RpcStatus& status = wait(true).status();
    answered_[static_cast<std::size_t>(agent)] |= status.ok();
    return status;
  }

  // The transport wants a text that lives as long as the program.
  static const char* name_of(proto::Rpc rpc) { return proto::name(rpc).data(); }

  void begin(int agent, const char* method, const google::protobuf::MessageLite& request,
             GrpcCall::Answer answer, RpcTimeout timeout, bool wait_for_ready = false) {
    if (cancelled()) {
      never_asked_.push_back(agent);
      return;
    }
    call_of(agent).start(stub_of(agent), queue_, method, request, answer, timeout, wait_for_ready);
    ++outstanding_;
  }

  // To a caller who waited for the connection, a deadline without one means that nobody is there.
  void blame_absence(RpcStatus& status, const GrpcCall& call) const {
    const auto i = static_cast<std::size_t>(agent_of(call));
    const bool absent = target_ && call.answer() == GrpcCall::Answer::kRegister &&
                        status.outcome == RpcOutcome::kDeadline &&
                        channels_[i]->GetState(false) != GRPC_CHANNEL_READY;
    if (!absent) return;
    const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(call.latency());
    status.outcome = RpcOutcome::kUnavailable;
    status.message = names_[i] + " is gone and did not come back within " +
                     std::to_string(waited.count()) + " ms";
  }

  Reply reply_of(const GrpcCall& call) {
    Reply reply;
    reply.agent = agent_of(call);
    reply.status = call.status();
    reply.latency = call.latency();
    blame_absence(reply.status, call);
    answered_[static_cast<std::size_t>(reply.agent)] |= reply.status.ok();
    if (call.message() == nullptr) return reply;
    switch (call.answer()) {
      case GrpcCall::Answer::kPlayer:
        reply.player = static_cast<const protos::PlayerActions*>(call.message());
        break;
      case GrpcCall::Answer::kCoach:
        reply.coach = static_cast<const protos::CoachActions*>(call.message());
        break;
      case GrpcCall::Answer::kTrainer:
        reply.trainer = static_cast<const protos::TrainerActions*>(call.message());
        break;
      case GrpcCall::Answer::kPlanner:
        reply.planner = static_cast<const protos::BestPlannerActionResponse*>(call.message());
        break;
      case GrpcCall::Answer::kRegister:
        reply.identity = static_cast<const protos::RegisterResponse*>(call.message());
        break;
      case GrpcCall::Answer::kEmpty:
        break;
    }
    return reply;
  }

  RpcStatus tls_status(int agent) const {
    const std::string trouble = target_ ? tls_trouble(*target_, agent) : std::string();
    if (trouble.empty()) return {};
    return {RpcOutcome::kUnavailable, static_cast<int>(grpc::StatusCode::UNAVAILABLE),
            names_[static_cast<std::size_t>(agent)] + ": " + trouble};
  }

  // Register waits for the Playmaker to come up, so a missing one looks like a slow one. Asking
  // once more without waiting tells them apart, and gives the reason.
  RpcStatus explain_silence(int agent, const protos::RegisterRequest& request, RpcTimeout timeout) {
    const auto i = static_cast<std::size_t>(agent);
    const std::string limit = std::to_string(timeout.count()) + " ms";
    if (channels_[i]->GetState(false) == GRPC_CHANNEL_READY) {
      return {RpcOutcome::kDeadline, static_cast<int>(grpc::StatusCode::DEADLINE_EXCEEDED),
              names_[i] + " did not answer Register within " + limit};
    }
    if (RpcStatus trouble = tls_status(agent); !trouble.ok()) return trouble;
    RpcStatus status = ask(agent, "Register", request, GrpcCall::Answer::kRegister, kProbeTimeout);
    if (status.outcome != RpcOutcome::kUnavailable) return status;
    status.message =
        names_[i] + " could not be reached within " + limit + " (" + status.message + ")";
    return status;
  }

  std::optional<GrpcTarget> target_;  // else the channel was given, and its state tells nothing
  std::array<std::shared_ptr<grpc::Channel>, kAgentNumbers> channels_;
  std::array<std::string, kAgentNumbers> names_;
  std::array<std::unique_ptr<grpc::GenericStub>, kAgentNumbers> stubs_;
  grpc::CompletionQueue queue_;
  std::array<GrpcCall, kAgentNumbers> calls_;
  std::array<bool, kAgentNumbers> answered_{};  // over the connection of now
  std::array<bool, kAgentNumbers> lost_{};      // that connection, not told yet
  int outstanding_ = 0;
  std::vector<int> never_asked_;  // begun after cancel()
  std::atomic<bool> cancelled_{false};
};

}  // namespace

std::unique_ptr<Playmaker> make_grpc_playmaker(std::shared_ptr<grpc::Channel> channel,
                                               std::string name) {
  return std::make_unique<GrpcPlaymaker>(std::move(channel), std::move(name));
}

std::unique_ptr<Playmaker> make_grpc_playmaker(const GrpcTarget& target) {
  return std::make_unique<GrpcPlaymaker>(target);
}

}  // namespace cls::proxy
