// Cycles of a team.
#include "proxy/agent/team.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace cls::proxy {
namespace {

constexpr RpcTimeout kByeTimeout{1000};
// In real time: for the way to the server, and the least that a Playmaker is given.
constexpr RpcTimeout kReserve{10};
constexpr RpcTimeout kShortestTimeout{10};

/// Adds the time since the last lap to a sum.
class StopWatch {
 public:
  void lap(std::chrono::nanoseconds& sum) {
    const auto now = std::chrono::steady_clock::now();
    sum += now - last_;
    last_ = now;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// A Playmaker that tells its agents apart by what it gave them cannot do so when all got the same.
constexpr int kNoClientId = 0;

bool reacts_to_bye(const RpcStatus& status) {
  return status.ok() || status.outcome == RpcOutcome::kUnimplemented ||
         status.outcome == RpcOutcome::kError;
}

protos::RegisterRequest register_request(const PlayerAgent& agent) {
  protos::RegisterRequest request;
  request.set_agent_type(protos::PlayerT);
  request.set_team_name(std::string(agent.options().team_name.view()));
  request.set_uniform_number(agent.unum());
  return request;
}

}  // namespace

Team::Team(TeamOptions options, Playmaker& playmaker)
    : options_(std::move(options)), name_(options_.name.view()), playmaker_(&playmaker) {}

base::Result<void> Team::connect(const OpenChannel& open, const Serve& serve) {
  for (int i = 0; i < options_.players; ++i) {
    const bool goalie = options_.goalie && i == 0;
    if (const base::Result<void> done = connect_one(open, serve, goalie); !done) return done;
  }
  return {};
}

base::Result<void> Team::connect_one(const OpenChannel& open, const Serve& serve, bool goalie) {
  const std::string who = name_ + ", player " + std::to_string(players_.size() + 1) + ": ";
  std::unique_ptr<soccer::Channel> channel = open();
  if (channel == nullptr) return base::Error{who + "no connection to the soccer server"};
  AgentOptions options;
  options.team_name = options_.name;
  options.goalie = goalie;
  options.protocol = options_.protocol;
  options.on_late = options_.on_late;
  options.formations = options_.formations;
  options.debug_log = options_.debug_log;
  if (options_.reconnect) {
    options.reconnect_unum = options_.first_unum + static_cast<int>(players_.size());
  }
  auto agent = std::make_unique<PlayerAgent>(std::move(channel), options);
  if (const base::Result<void> entered = enter(*agent, serve); !entered) {
    return base::Error{who + entered.error().message};
  }
  players_.push_back(std::move(agent));
  return {};
}

RpcStatus Team::introduce() {
  for (const auto& agent : players_) {
    Correspondence& calls = correspondence_[static_cast<std::size_t>(agent->unum())].emplace(
        agent->unum(), proto::Rpc::kGetPlayerActions, register_request(*agent),
        agent->world().parameters);
    RpcStatus status = calls.introduce(*playmaker_, options_.start_timeout, agent->question());
    if (const std::string remark = calls.take_remark(); !remark.empty()) warn_once(remark);
    if (!status.ok()) {
      status.message = "player " + std::to_string(agent->unum()) + ": " + status.message;
      return status;
    }
  }
  warn_of_shared_identity();
  return coach_ == nullptr ? RpcStatus{} : introduce_coach();
}

void Team::warn_of_shared_identity() {
  if (!options_.one_playmaker) return;
  std::map<int, int> holders;  // unum by client id
  for (const auto& agent : players_) {
    const int id = agent->identity().client_id();
    const auto [holder, fresh] = holders.emplace(id, agent->unum());
    if (fresh || id == kNoClientId) continue;
    warn_once("the Playmaker gave players " + std::to_string(holder->second) + " and " +
              std::to_string(agent->unum()) + " the same client_id " + std::to_string(id));
    return;
  }
}

Correspondence& Team::correspondence(int unum) {
  std::optional<Correspondence>& calls = correspondence_.at(static_cast<std::size_t>(unum));
  assert(calls && "a team is introduced before it asks");
  return *calls;
}

PlayerAgent& Team::agent(int unum) {
  const auto found = std::find_if(players_.begin(), players_.end(),
                                  [unum](const auto& agent) { return agent->unum() == unum; });
  assert(found != players_.end());
  return **found;
}

int Team::begin_cycle() { return ask({}); }

int Team::ask(Instant now) {
  int asked = 0;
  StopWatch watch;
  for (const auto& agent : players_) {
    agent->perceive();
    watch.lap(times_.perceive);
    if (!agent->decision_due(now)) continue;
    agent->state(now);
    watch.lap(times_.state);
    correspondence(agent->unum()).ask(*playmaker_, agent->question(), asking_time(*agent, now));
    watch.lap(times_.begin);
    ++asked;
  }
  asked += ask_coach(now);
  outstanding_ += asked;
  return asked;
}

void Team::finish_cycle() {
  StopWatch watch;
  while (const std::optional<Reply> reply = playmaker_->next_reply()) {
    watch.lap(times_.wait);
    carry_out(*reply);
    watch.lap(times_.act);
  }
}

bool Team::take_reply(std::chrono::microseconds longest) {
  StopWatch watch;
  const std::optional<Reply> reply = playmaker_->next_reply_within(longest);
  watch.lap(times_.wait);
  if (!reply) return false;
  carry_out(*reply);
  watch.lap(times_.act);
  return true;
}

Instant Team::next_due() const {
  Instant next = Instant::max();
  for (const auto& agent : players_) {
    if (!agent->deciding()) next = std::min(next, agent->timer().due_at());
  }
  return next;
}

AskingTime Team::asking_time(const PlayerAgent& agent, Instant now) const {
  AskingTime time;
  time.timeout = decision_timeout(agent, now);
  time.server_waits = agent.timer().synchronous();
  time.reconnect_within = options_.reconnect_within;
  return time;
}

// In real time, an answer after the end of the cycle would be of no use.
RpcTimeout Team::decision_timeout(const PlayerAgent& agent, Instant now) const {
  const bool unlimited = options_.decision_timeout == kNoTimeout;
  if (agent.timer().synchronous() || unlimited) return options_.decision_timeout;
  const soccer::ServerParams& server = agent.world().server();
  const RpcTimeout cycle(server.simulator_step * server.slow_down_factor);
  const auto gone = std::chrono::duration_cast<RpcTimeout>(now - agent.timer().cycle_began());
  return std::min(options_.decision_timeout, std::max(kShortestTimeout, cycle - kReserve - gone));
}

int Team::run_cycle() {
  const int asked = begin_cycle();
  finish_cycle();
  return asked;
}

void Team::carry_out(Reply reply) {
  if (reply.agent >= kCoachNumber) return carry_out_coach(std::move(reply));
  PlayerAgent& asker = agent(reply.agent);
  if (asker.awaits_choice()) {
    --outstanding_;
    carry_out_choice(asker, reply);
    return;
  }
  Correspondence& calls = correspondence(reply.agent);
  const bool decided = calls.take(*playmaker_, reply);
  if (const std::string remark = calls.take_remark(); !remark.empty()) warn_once(remark);
  if (!decided) return;
  --outstanding_;
  note(asker, calls, reply);
  if (reply.player == nullptr) {
    asker.act_without_reply();
  } else if (!asker.act(*reply.player)) {
    ask_for_choice(asker);
    return;
  }
  warn_of_unimplemented(asker);
  warn_of_server(asker.server().trouble);
}

void Team::note(PlayerAgent& asker, const Correspondence& calls, const Reply& reply) {
  AgentStatistics& statistics = asker.statistics();
  statistics.count(reply);
  if (calls.reconnects() == statistics.reconnects) return;
  statistics.reconnects = calls.reconnects();
  warn_once("the Playmaker was lost and came back: told of its players again at cycle " +
            std::to_string(asker.world().game.time.cycle));
}

void Team::ask_for_choice(PlayerAgent& asker) {
  ++asker.statistics().planner_asked;
  const RpcTimeout timeout = decision_timeout(asker, std::chrono::steady_clock::now());
  playmaker_->begin_best_planner_action(asker.unum(), asker.planner_request(), timeout);
  ++outstanding_;
}

void Team::carry_out_choice(PlayerAgent& asker, const Reply& reply) {
  if (reply.planner != nullptr) {
    asker.act_on_choice(reply.planner->index());
  } else {
    ++asker.statistics().planner_failed;
    warn_once("the Playmaker did not choose a planned action: " + reply.status.message);
    asker.act_on_choice(std::nullopt);
  }
  warn_of_unimplemented(asker);
  warn_of_server(asker.server().trouble);
}

void Team::leave() {
  bool reacts = true;
  for (const auto& agent : players_) {
    if (reacts && agent->has_identity()) {
      const RpcStatus status = playmaker_->send_bye(agent->unum(), agent->identity(), kByeTimeout);
      reacts = reacts_to_bye(status);
    }
    agent->leave();
  }
  if (coach_ != nullptr && reacts && coach_->has_identity()) {
    playmaker_->send_bye(coach_->number(), coach_->identity(), kByeTimeout);
  }
  if (coach_ != nullptr) coach_->leave();
}

soccer::Side Team::side() const {
  const bool trains = coach_ != nullptr && coach_->is_trainer();
  if (players_.empty() && (coach_ == nullptr || trains)) return soccer::Side::kNeutral;
  return world().our_side;
}

MissingAnswers Team::missing_answers() const {
  MissingAnswers worst;
  for (const auto& agent : players_) {
    const AgentStatistics& statistics = agent->statistics();
    if (statistics.missed_in_a_row <= worst.in_a_row) continue;
    worst = {agent->unum(), statistics.missed_in_a_row, statistics.last_failure};
  }
  if (coach_ == nullptr) return worst;
  // A team plays on with a coach that fails; one that does not answer holds up the match.
  const AgentStatistics& statistics = coach_->statistics();
  const bool fails = statistics.last_failure.outcome == RpcOutcome::kError;
  if (statistics.missed_in_a_row > worst.in_a_row && (coach_->is_trainer() || !fails)) {
    worst = {coach_->number(), statistics.missed_in_a_row, statistics.last_failure};
  }
  return worst;
}

void Team::warn_once(const std::string& line) {
  if (std::find(warnings_.begin(), warnings_.end(), line) == warnings_.end()) {
    warnings_.push_back(line);
  }
}

void Team::warn_of_unimplemented(const PlayerAgent& agent) {
  const ActionReport& report = agent.statistics().actions;
  const auto warn = [&](const auto& counts, auto& told, const char* verb, auto name_of) {
    for (std::size_t kind = 0; kind < told.size(); ++kind) {
      if (counts[kind].unimplemented == 0 || std::exchange(told[kind], true)) continue;
      warn_once(std::string("the Playmaker ") + verb + " " +
                std::string(name_of(static_cast<int>(kind))) +
                ", which this proxy does not have: skipped");
    }
  };
  warn(report.actions, told_actions_, "asks for", action_name);
  warn(report.say, told_say_, "says", say_name);
}

void Team::warn_of_server(const ServerTrouble& trouble) {
  if (trouble.unreadable != 0) {
    warn_once("a message of the soccer server is not understood: " + trouble.first_unreadable);
  }
  if (trouble.errors != 0) {
    warn_once("the soccer server complains: " + trouble.first_error);
  }
  if (trouble.warnings != 0) {
    warn_once("the soccer server warns: " + trouble.first_warning);
  }
}

std::vector<std::string> Team::take_warnings() {
  const auto first = warnings_.begin() + static_cast<std::ptrdiff_t>(warnings_taken_);
  std::vector<std::string> fresh(first, warnings_.end());
  warnings_taken_ = warnings_.size();
  return fresh;
}

}  // namespace cls::proxy
