// Putting one side together, and reading off what it did.
#include "orchestration/match/sides/match_side.h"

#include <chrono>
#include <utility>

#include "orchestration/match/sides/playmaker_link.h"
#include "proxy/playmaker/grpc_playmaker.h"

namespace cls::orchestration::match {
namespace {

using base::Result;

proxy::RpcTimeout milliseconds_of(double seconds) {
  return std::chrono::duration_cast<proxy::RpcTimeout>(std::chrono::duration<double>(seconds));
}

proxy::TeamOptions team_options(const SideSetup& setup, const Endpoint& endpoint,
                                const MatchOptions& options) {
  proxy::TeamOptions team;
  team.name = soccer::TeamName(setup.name);
  // A trainer has none, and of a foreign team's side there is only the name (see ForeignGuests).
  if (setup.side == soccer::Side::kNeutral || !endpoint.has_playmaker()) team.players = 0;
  team.formations =
      setup.side == soccer::Side::kRight ? options.right_formations : options.left_formations;
  team.protocol = options.protocol;
  team.on_late = options.on_late;
  team.decision_timeout = decision_deadline(options).value_or(proxy::kNoTimeout);
  team.start_timeout = milliseconds_of(options.start_timeout_s);
  team.reconnect_within = milliseconds_of(options.reconnect_within_s);
  team.one_playmaker = !endpoint.port_step;
  return team;
}

std::map<std::string, std::int64_t> missed_by(const proxy::AgentStatistics& statistics) {
  std::map<std::string, std::int64_t> by_outcome;
  for (int i = 1; i < proxy::kRpcOutcomes; ++i) {
    const std::int64_t n = statistics.outcomes[static_cast<std::size_t>(i)];
    const bool ours = static_cast<proxy::RpcOutcome>(i) == proxy::RpcOutcome::kCancelled;
    if (n != 0 && !ours) by_outcome.emplace(name(static_cast<proxy::RpcOutcome>(i)), n);
  }
  return by_outcome;
}

}  // namespace

PlayerResult result_of(int number, const proxy::AgentStatistics& statistics) {
  PlayerResult result;
  result.unum = number;
  result.decisions = statistics.decisions;
  result.late = statistics.late;
  result.missed = statistics.missed;
  result.undecided = statistics.undecided;
  result.lost_commands = statistics.lost_commands;
  result.late_wakeups = statistics.late_wakeups;
  result.rpc_us.p50 = statistics.rpc_us.percentile(0.50);
  result.rpc_us.p95 = statistics.rpc_us.percentile(0.95);
  result.rpc_us.p99 = statistics.rpc_us.percentile(0.99);
  result.rpc_us.max = statistics.rpc_us.max();
  result.commands = statistics.commands_by_name();
  result.unimplemented_actions = statistics.unimplemented_by_name();
  result.missed_by = missed_by(statistics);
  result.reconnects = statistics.reconnects;
  return result;
}

Result<std::unique_ptr<MatchSide>> MatchSide::create(const Endpoint& endpoint,
                                                     const SideSetup& setup,
                                                     const MatchOptions& options) {
  std::unique_ptr<MatchSide> side(new MatchSide);
  side->is_trainer_ = setup.side == soccer::Side::kNeutral;
  side->name_ = side->is_trainer_ ? "trainer" : setup.name;
  side->endpoint_ = endpoint;
  if (endpoint.kind == Endpoint::Kind::kMock) {
    auto mock = start_mock(endpoint);
    if (!mock) return mock.error();
    side->mock_ = std::move(*mock);
    side->playmaker_ = proxy::make_grpc_playmaker(side->mock_->in_process_channel(), endpoint.text);
  } else if (endpoint.kind == Endpoint::Kind::kRun) {
    auto program = PlaymakerProgram::start(
        *setup.host, endpoint, {0, setup.side, setup.name, setup.seed}, setup.folder, setup.cpus);
    if (!program) return program.error();
    side->program_ = std::move(*program);
    proxy::GrpcTarget target;
    target.host = "localhost";
    target.port = side->program_->port();
    side->playmaker_ = proxy::make_grpc_playmaker(target);
  } else if (endpoint.kind == Endpoint::Kind::kTeam) {
    side->playmaker_ = proxy::make_grpc_playmaker(proxy::GrpcTarget());  // nobody asks it
  } else {
    side->playmaker_ = proxy::make_grpc_playmaker(target_of(endpoint));
  }
  side->worker_.run_on(setup.cpus);
  side->team_ =
      std::make_unique<proxy::Team>(team_options(setup, endpoint, options), *side->playmaker_);
  return side;
}

void MatchSide::listen(proxy::RpcListener& listener) {
  proxy::Playmaker& inner = listened_.empty() ? *playmaker_ : *listened_.back();
  listened_.push_back(proxy::listen_to(inner, listener));
  team_->set_playmaker(*listened_.back());
}

TeamResult MatchSide::result() const {
  TeamResult result;
  result.name = name_;
  result.endpoint = endpoint_.text;
  result.cpu_seconds = worker_.cpu_seconds() + mock_cpu_seconds();
  if (program_ != nullptr) result.cpu_seconds += program_->child().cpu_seconds();
  for (const auto& agent : team_->players()) {
    result.players.push_back(result_of(agent->unum(), agent->statistics()));
  }
  if (const proxy::CoachAgent* coach = team_->coach()) {
    result.coach = result_of(coach->number(), coach->statistics());
    result.coach->commands = coach->commands();
  }
  return result;
}

std::vector<std::string> MatchSide::failed_expectations() const {
  return mock_ == nullptr ? std::vector<std::string>() : mock_->failed_expectations();
}

double MatchSide::mock_cpu_seconds() const {
  constexpr double kNanosecond = 1e-9;
  if (mock_ == nullptr) return 0.0;
  return static_cast<double>(mock_->decision_nanoseconds()) * kNanosecond;
}

}  // namespace cls::orchestration::match
