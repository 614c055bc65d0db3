// Collecting calls, one at a time in flight for the team, and taking their replies apart.
#include "proxy/playmaker/batch_playmaker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <deque>
#include <iterator>
#include <map>
#include <utility>

#include "base/index.h"
#include "proto/sorted_maps.h"
#include "proto/state_writer.h"
#include "proto/team_playmaker.pb.h"
#include "proxy/messages/parameter_messages.h"
#include "proxy/playmaker/forwarding_playmaker.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "proxy/playmaker/replies.h"
#include "proxy/playmaker/tensor_calls.h"

namespace cls::proxy {
namespace {

namespace wire = cls::playmaker::v1;
using google::protobuf::Message;
using proto::Rpc;

bool is_player(int agent) { return agent != kTeamNumber && agent < kCoachNumber; }

// An array with an element for each agent.
template <typename T>
struct ByAgent : std::array<T, kAgentNumbers> {
  T& of(int agent) { return this->at(base::index(agent)); }
};

// Adds an agent without its message; returns the bytes to write.
std::string& add_agent(int agent, google::protobuf::RepeatedPtrField<wire::AgentMessage>& agents) {
  wire::AgentMessage& one = *agents.Add();
  one.set_agent(agent);
  return *one.mutable_message();
}

// The calls begun for one RPC of the team, and not sent yet.
template <typename Request>
struct Collected {
  Request request;  // its memory is reused
  RpcTimeout timeout{0};
  bool wait_for_ready = false;

  bool empty() const { return request.agents().empty(); }
  // Returns the bytes of the agent's message, to be written.
  // While some still wait for the connection and others have given it up, the time of those that
  // wait counts: with the time of the others, the call would wait for it just as long.
  std::string& add(int agent, RpcTimeout call_timeout, bool wait) {
    if (wait && !wait_for_ready) timeout = RpcTimeout{0};
    if (wait || !wait_for_ready) timeout = std::max(timeout, call_timeout);
    wait_for_ready = wait_for_ready || wait;
    return add_agent(agent, *request.mutable_agents());
  }
  void clear() {
    request.Clear();
    timeout = RpcTimeout{0};
    wait_for_ready = false;
  }
};

/// The calls of the team. After a Playmaker has refused them, only begin_alone() and left_reply()
/// are called.
class TeamCalls : public Playmaker {
 public:
  TeamCalls(Playmaker& inner, BatchMode mode) : inner_(inner), mode_(mode) {}

  /// The last call had no reply for an agent, because the Playmaker needs the calls of Game.
  bool refused() const { return refused_; }

  void announce_team(TeamRegistration team) override {
    team_ = std::move(team);
    registered_.fill(false);
  }

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    asked_.of(agent) = rpc;
    if (is_decision(rpc)) {
      add_decision(agent, static_cast<const protos::State&>(request),
                   decisions_.add(agent, timeout, wait_for_ready));
    } else if (rpc == Rpc::kGetBestPlannerAction) {
      proto::write_with_sorted_maps(request, choices_.add(agent, timeout, wait_for_ready));
    } else if (rpc == Rpc::kRegister) {
      request.SerializeToString(&registrations_.add(agent, timeout, wait_for_ready));
    } else {
      replies_.push_back(sent_with_registration(agent, rpc));
    }
  }

  void send() override {
    if (in_flight_) return;
    if (!registrations_.empty()) {
      add_parameters(registrations_.request);
      send(registrations_, Rpc::kRegisterTeam);
    } else if (!decisions_.empty()) {
      decisions_.request.set_sequence(++sequence_);
      send(decisions_, Rpc::kGetTeamActions);
    } else if (!choices_.empty()) {
      send(choices_, Rpc::kGetBestPlannerActions);
    }
  }

  Reply call(int agent, Rpc rpc, const Message& /*request*/, RpcTimeout timeout) override {
    if (rpc == Rpc::kSendByeCommand) return goodbye(agent, timeout);
    if (rpc != Rpc::kRegister) return sent_with_registration(agent, rpc);
    if (!registered_.of(agent)) register_team(timeout);
    return refused_ ? empty_reply(agent, rpc) : registration_of(agent);
  }

  bool take_connection_loss(int agent) override {
    if (inner_.take_connection_loss(kTeamNumber)) lost_.fill(true);
    return std::exchange(lost_.of(agent), false);
  }

  std::optional<Reply> next_reply() override {
    while (!refused_) {
      if (std::optional<Reply> reply = collected_reply()) return reply;
      const std::optional<Reply> reply = inner_.next_reply();
      if (!reply) return std::nullopt;
      take_apart(*reply);
    }
    return std::nullopt;
  }

  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    if (std::optional<Reply> reply = collected_reply()) return reply;
    const std::optional<Reply> reply = inner_.next_reply_within(timeout);
    if (!reply) return std::nullopt;
    take_apart(*reply);
    return refused_ ? std::nullopt : collected_reply();
  }

  std::string take_warning() override { return std::exchange(warning_, {}); }

  void cancel() override { inner_.cancel(); }

  /// A restarted Playmaker has no TeamPlaymaker: begins the calls that were to be one call.
  void begin_alone() {
    for (const auto& [agent, registration] : team_.agents) {
      if (is_due(agent)) inner_.begin(agent, Rpc::kRegister, registration, kRegisterTimeout);
    }
    for (const auto& one : decisions_.request.agents()) {
      fail(one.agent(), {RpcOutcome::kError, 0, "the Playmaker has restarted"});
    }
    decisions_.clear();
  }

  /// A reply that is here already.
  std::optional<Reply> left_reply() {
    if (replies_.empty()) return std::nullopt;
    return take_first(replies_);
  }

 private:
  bool is_due(int agent) const { return std::ranges::find(due_, agent) != due_.end(); }

  // The agent's call has failed, with the call of the team or alone.
  void fail(int agent, RpcStatus status, std::chrono::microseconds latency = {}) {
    replies_.push_back(failed_reply(agent, asked_.of(agent), std::move(status)));
    replies_.back().latency = latency;
  }

  // A State, or a row of numbers, whose agent needs no `bytes`.
  void add_decision(int agent, const protos::State& state, std::string& bytes) {
    const bool first = decisions_.request.agents_size() == 1;
    if (first) decisions_.request.set_cycle(state.world_model().cycle());

    if (tensors_.active() && is_player(agent)) {
      tensors_.add_player(team_.world_of(agent), first, decisions_.request);
    } else {
      const bool lean = encoding_ == wire::LEAN_STATES;
      bytes = writer_.write(state, lean ? proto::StateForm::kLean : proto::StateForm::kWhole);
    }
  }

  // The rest of the handshake of an agent: RegisterTeam carried it.
  static Reply sent_with_registration(int agent, Rpc rpc) {
    static const protos::Empty kEmpty;
    Reply reply = empty_reply(agent, rpc);
    reply.message = &kEmpty;
    return reply;
  }

  // A reply that is here already; sends what waits when there is none.
  std::optional<Reply> collected_reply() {
    if (replies_.empty()) send();
    return left_reply();
  }

  template <typename Request>
  void send(Collected<Request>& calls, Rpc rpc) {
    due_.clear();
    for (const auto& one : calls.request.agents()) due_.push_back(one.agent());
    in_flight_ = true;
    inner_.begin(kTeamNumber, rpc, calls.request, calls.timeout, calls.wait_for_ready);
    calls.clear();
  }

  // The rest of a registration, next to its agents.
  void add_parameters(wire::RegisterTeamRequest& request) const {
    assert(team_.parameters != nullptr && "announce_team() comes first");
    const player::MatchParameters& parameters = *team_.parameters;
    request.set_version(proto::kTeamPlaymakerVersion);

    const auto write = [](auto message, std::string& bytes, const auto&... from) {
      fill(from..., message);
      message.clear_register_response();
      message.SerializeToString(&bytes);
    };
    write(protos::ServerParam(), *request.mutable_server_params(), parameters.server);
    write(protos::PlayerParam(), *request.mutable_player_params(), parameters.player);
    for (const soccer::PlayerType& type : parameters.types) {
      write(protos::PlayerType(), *request.add_player_types(), type, parameters.server);
    }
    protos::InitMessage().SerializeToString(request.mutable_init_message());

    request.add_encodings(wire::STATES);
    request.add_encodings(wire::LEAN_STATES);
    TensorCalls::offer(team_, request);
  }

  // Registers the announced team and stores the result for each agent.
  void register_team(RpcTimeout timeout) {
    wire::RegisterTeamRequest request;
    due_.clear();
    for (const auto& [agent, registration] : team_.agents) {
      registration.SerializeToString(&add_agent(agent, *request.mutable_agents()));
      asked_.of(agent) = Rpc::kRegister;
      due_.push_back(agent);
    }
    add_parameters(request);
    sequence_ = 0;

    Reply reply = inner_.call(kTeamNumber, Rpc::kRegisterTeam, request, timeout);
    // It is connected and leaves the call unanswered: it may know Register.
    if (reply.status.outcome == RpcOutcome::kDeadline) reply.status.outcome = RpcOutcome::kError;
    take_apart(reply);
    if (refused_) return;

    for (Reply& one : replies_) {
      registered_.of(one.agent) = true;
      registrations_taken_.of(one.agent) = std::move(one);
    }
    replies_.clear();
  }

  // The stored registration of this agent. A later Register makes a new call.
  Reply registration_of(int agent) {
    registered_.of(agent) = false;
    return registrations_taken_.of(agent);
  }

  Reply goodbye(int agent, RpcTimeout timeout) {
    if (!goodbye_) {
      wire::UnregisterTeamRequest request;
      for (const auto& [one, identity] : identities_) {
        add_agent(one, *request.mutable_agents()) = identity;
      }
      goodbye_ = inner_.call(kTeamNumber, Rpc::kUnregisterTeam, request, timeout).status;
    }
    return goodbye_->ok() ? sent_with_registration(agent, Rpc::kSendByeCommand)
                          : failed_reply(agent, Rpc::kSendByeCommand, *goodbye_);
  }

  // Turns the reply to the team into replies to the agents of `due_`.
  void take_apart(const Reply& reply) {
    in_flight_ = false;
    rows_.clear();
    if (is_registration(reply.rpc) && refuses_batch(reply)) return;
    if (!reply.status.ok()) {
      for (const int agent : due_) fail(agent, reply.status, reply.latency);
      return;
    }

    if (const auto* registered = reply.as<wire::RegisterTeamResponse>()) {
      for (const int agent : due_) lost_.of(agent) = false;
      encoding_ = registered->encoding();
      hand_out(reply, registered->agents());
    } else if (const auto* actions = reply.as<wire::GetTeamActionsResponse>()) {
      hand_out_actions(reply, *actions);
    } else if (const auto* choices = reply.as<wire::GetBestPlannerActionsResponse>()) {
      hand_out(reply, choices->agents());
    }
  }

  // The problem with a registration that the Playmaker has accepted; empty: none.
  std::string problem_of(const wire::RegisterTeamResponse& registered) {
    const base::Result<void> tensors = tensors_.choose(team_, registered);
    if (registered.version() != proto::kTeamPlaymakerVersion) {
      return fmt::format("it speaks version {} of TeamPlaymaker, not {}", registered.version(),
                         proto::kTeamPlaymakerVersion);
    }

    if (!tensors) return tensors.error().message;
    if (!tensors_.active() && registered.encoding() != wire::STATES &&
        registered.encoding() != wire::LEAN_STATES) {
      return fmt::format("it chose encoding {}, which was not offered",
                         static_cast<int>(registered.encoding()));
    }

    return {};
  }

  // Whether the Playmaker needs the calls of Game, or is refused with kRequired.
  bool refuses_batch(const Reply& reply) {
    const RpcOutcome outcome = reply.status.outcome;
    std::string why;
    if (const auto* registered = reply.as<wire::RegisterTeamResponse>()) {
      why = problem_of(*registered);
      if (why.empty()) return false;
    } else if (outcome == RpcOutcome::kError || outcome == RpcOutcome::kProtocolError) {
      why = reply.status.message;
    } else if (outcome == RpcOutcome::kUnimplemented) {
      if (mode_ == BatchMode::kRequired) why = "it does not implement TeamPlaymaker";
    } else {
      return false;
    }

    if (mode_ == BatchMode::kRequired) {
      for (const int agent : due_) fail(agent, {RpcOutcome::kError, reply.status.code, why});
      return true;
    }
    if (!why.empty()) warning_ = "the Playmaker decides for each agent alone: " + why;
    refused_ = true;
    return true;
  }

  // Rows of players become action lists, unless the player has a reply of its own.
  void hand_out_actions(const Reply& team, const wire::GetTeamActionsResponse& response) {
    if (!tensors_.active()) return hand_out(team, response.agents());
    std::ranges::copy_if(due_, std::back_inserter(rows_), is_player);
    const base::Result<void> read = tensors_.read(response, rows_.size());
    if (!read || !tensors_.has_rows()) rows_.clear();
    hand_out(team, response.agents());
    if (read) return;
    for (Reply& one : replies_) {
      if (!one.status.ok()) one.status = {RpcOutcome::kProtocolError, 0, read.error().message};
    }
  }

  // The reply in the agent's row of the actions; nullopt if it has none.
  std::optional<Reply> reply_in_row(const Reply& team, int agent) {
    const auto place = std::ranges::find(rows_, agent);
    if (place == rows_.end()) return std::nullopt;

    const Rpc rpc = asked_.of(agent);
    const std::size_t row = base::index(place - rows_.begin());
    const protos::PlayerActions* actions = tensors_.actions(row, team_.world_of(agent));
    if (actions == nullptr) {
      return failed_reply(
          agent, rpc,
          {RpcOutcome::kProtocolError, 0,
           fmt::format("{}: the row of {} is not an action", name(team.rpc), agent_name(agent))});
    }

    Reply reply = empty_reply(agent, rpc);
    Message& message = memory_.of(agent).create(rpc);
    message.CopyFrom(*actions);
    reply.message = &message;
    reply.latency = team.latency;
    return reply;
  }

  template <typename Replies>
  void hand_out(const Reply& team, const Replies& replies) {
    ByAgent<bool> answered{};
    for (const wire::AgentReply& one : replies) {
      const int agent = one.agent();
      const bool due = is_due(agent);
      if (!due || answered.of(agent)) {
        warning_ =
            fmt::format("{}: {} for {}, {}", name(team.rpc), due ? "another reply" : "a reply",
                        agent_name(agent), due ? "ignored" : "who was not asked");
        continue;
      }
      answered.of(agent) = true;
      replies_.push_back(reply_of(team, one));
    }

    for (const int agent : due_) {
      if (answered.of(agent)) continue;
      if (std::optional<Reply> reply = reply_in_row(team, agent)) {
        replies_.push_back(std::move(*reply));
        continue;
      }

      fail(agent,
           {RpcOutcome::kDeadline, 0,
            fmt::format("{}: the reply lacks {}", name(team.rpc), agent_name(agent))},
           team.latency);
    }
    std::ranges::sort(replies_, {}, &Reply::agent);
  }

  Reply reply_of(const Reply& team, const wire::AgentReply& one) {
    const int agent = one.agent();
    const Rpc rpc = asked_.of(agent);
    Reply reply = empty_reply(agent, rpc);
    reply.latency = team.latency;
    if (one.code() != 0) {
      reply.status = rpc_status(rpc, one.code(), one.error());
      return reply;
    }
    if (rpc == Rpc::kRegister) identities_[agent] = one.message();
    memory_.of(agent).parse(one.message(), reply);
    return reply;
  }

  Playmaker& inner_;
  BatchMode mode_;
  bool refused_ = false;  // the Playmaker has no TeamPlaymaker
  TeamRegistration team_;
  ByAgent<bool> registered_{};  // not handed out yet
  ByAgent<Reply> registrations_taken_;
  Collected<wire::RegisterTeamRequest> registrations_;
  Collected<wire::GetTeamActionsRequest> decisions_;
  Collected<wire::GetBestPlannerActionsRequest> choices_;
  ByAgent<Rpc> asked_{};   // the latest call of each agent
  std::vector<int> due_;   // agents of the call in flight
  std::vector<int> rows_;  // players of the rows of actions in a reply
  TensorCalls tensors_;
  bool in_flight_ = false;
  std::uint64_t sequence_ = 0;
  wire::Encoding encoding_ = wire::STATES;
  proto::StateWriter writer_;
  std::deque<Reply> replies_;
  ByAgent<ReplyMemory> memory_;
  ByAgent<bool> lost_{};
  std::map<int, std::string> identities_;  // protos.RegisterResponse by agent
  std::optional<RpcStatus> goodbye_;
  std::string warning_;
};

/// The calls of Game, once the Playmaker has refused those of the team.
class AgentCalls : public ForwardingPlaymaker {
 public:
  /// `team` may have replies that were not handed out yet.
  AgentCalls(Playmaker& inner, TeamCalls& team) : ForwardingPlaymaker(inner), team_(team) {}

  std::optional<Reply> next_reply() override {
    if (std::optional<Reply> reply = team_.left_reply()) return reply;
    return ForwardingPlaymaker::next_reply();
  }

  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    if (std::optional<Reply> reply = team_.left_reply()) return reply;
    return ForwardingPlaymaker::next_reply_within(timeout);
  }

 private:
  TeamCalls& team_;
};

/// Has two states: it asks for the team until the Playmaker refuses that, and for each agent alone
/// from then on.
class BatchPlaymaker : public Playmaker {
 public:
  BatchPlaymaker(std::unique_ptr<Playmaker> inner, BatchMode mode)
      : inner_(std::move(inner)), team_(*inner_, mode), alone_(*inner_, team_), state_(&team_) {}

  void announce_team(TeamRegistration team) override { state_->announce_team(std::move(team)); }

  void begin(int agent, Rpc rpc, const Message& request, RpcTimeout timeout,
             bool wait_for_ready) override {
    state_->begin(agent, rpc, request, timeout, wait_for_ready);
  }

  void send() override { state_->send(); }

  Reply call(int agent, Rpc rpc, const Message& request, RpcTimeout timeout) override {
    Reply reply = state_->call(agent, rpc, request, timeout);
    return was_refused() ? state_->call(agent, rpc, request, timeout) : reply;
  }

  bool take_connection_loss(int agent) override { return state_->take_connection_loss(agent); }

  std::optional<Reply> next_reply() override {
    std::optional<Reply> reply = state_->next_reply();
    if (!was_refused()) return reply;
    team_.begin_alone();
    return state_->next_reply();
  }

  std::optional<Reply> next_reply_within(std::chrono::microseconds timeout) override {
    std::optional<Reply> reply = state_->next_reply_within(timeout);
    if (!was_refused()) return reply;
    team_.begin_alone();
    return state_->next_reply_within(std::chrono::microseconds(0));
  }

  std::string take_warning() override { return team_.take_warning(); }
  void cancel() override { inner_->cancel(); }

 private:
  /// True once, after the call that was refused; changes the state.
  bool was_refused() {
    if (state_ == &alone_ || !team_.refused()) return false;
    state_ = &alone_;
    return true;
  }

  std::unique_ptr<Playmaker> inner_;
  TeamCalls team_;
  AgentCalls alone_;
  Playmaker* state_;
};

}  // namespace

std::unique_ptr<Playmaker> make_batch_playmaker(std::unique_ptr<Playmaker> inner, BatchMode mode) {
  if (mode == BatchMode::kOff) return inner;
  return std::make_unique<BatchPlaymaker>(std::move(inner), mode);
}

}  // namespace cls::proxy
