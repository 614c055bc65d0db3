// Life of an external server, and its result from the game log.
#include "match/server/external_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "base/system/version.h"
#include "base/text/printable.h"
#include "gamelog/rcg/rcg_reader.h"
#include "match/result/match_folder.h"
#include "match/server/client_binding.h"
#include "match/terms/server_settings.h"
#include "proxy/agent/team_driver.h"

namespace cls::match {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kLogPollInterval{10};
constexpr milliseconds kPortCheckInterval{30};
constexpr milliseconds kServerGrace{1500};
constexpr milliseconds kExitTimeout{10'000};
// A server in synchronous mode gives up after this many cycles without a (done).
constexpr int kMaxMissed = 20;
constexpr int kServerWriteError = 74;  // exit code of `cls server` (sysexits.h: EX_IOERR)

// The log of a half that has ended lacks its last frame, not its clock.
int last_cycle(const gamelog::MatchRecord& record, int cycles) {
  return record.notes.empty() ? cycles : std::max(cycles, record.notes.back().time);
}

}  // namespace

ExternalServer::ExternalServer(const MatchOptions& options, MatchPlan plan,
                               process::ProcessHost* host, const std::filesystem::path& folder)
    : options_(options),
      plan_(std::move(plan)),
      host_(host),
      folder_(folder),
      log_(plan_.server ? folder / kGameLogFile : std::filesystem::path()) {}

MatchEnd ExternalServer::refused(std::string message) const {
  MatchEnd end{.reason = EndReason::kRefused, .message = std::move(message)};
  if (child_ != nullptr) end.failure = failure_of(*child_);
  return end;
}

base::Result<void> ExternalServer::open_relay(
    soccer::Side side, std::shared_ptr<const process::Namespaces> namespaces) {
  const ServerPorts inside;
  RelayRoute route;
  route.side = side;
  TRY_INIT(route.players, base::parse_ip_address(kLoopback, inside.player));
  TRY_INIT(route.coaches, base::parse_ip_address(kLoopback, inside.coach));
  TRY_INIT(route.server_players, base::resolve_udp(plan_.server_host, plan_.ports.player));
  TRY_INIT(route.server_coaches, base::resolve_udp(plan_.server_host, plan_.ports.coach));
  route.bind = [namespaces = std::move(namespaces)](const base::SocketAddress& local) {
    return namespaces->door().bind_udp(local);
  };
  TRY_INIT(relays_[side], ServerRelay::create(std::move(route), names_));
  return {};
}

// The server gets sockets in the networks of the sides, so that nothing passes the relays in play.
base::Result<void> ExternalServer::trap_connections() {
  if (relays_[soccer::Side::kLeft] == nullptr && relays_[soccer::Side::kRight] == nullptr)
    return {};
  const auto socket_for = [this](const base::SocketAddress& peer) {
    std::optional<base::UdpSocket> socket;
    for (const soccer::Side side : soccer::kBothSides) {
      if (!socket && relays_[side] != nullptr) socket = relays_[side]->hand_over(peer);
    }
    return socket;
  };

  TRY_INIT(trap_, process::ConnectionTrap::create(socket_for));
  trap_->add_to(*plan_.server);
  return {};
}

bool ExternalServer::has_open_port() const {
  const std::vector<int> ports = process::ports_of(process::Protocol::kUdp, child_->status().pid);
  return std::ranges::find(ports, plan_.ports.player) != ports.end();
}

std::optional<MatchEnd> ExternalServer::start(const std::function<bool()>& keep_waiting) {
  if (!plan_.server) {
    const auto clients = soccer::UdpClients::create(plan_.server_host, plan_.ports.player);
    if (!clients) return refused(clients.error().message);
    proxy::wait_for_server(**clients, keep_waiting);
    return std::nullopt;
  }

  if (const auto trapped = trap_connections(); !trapped) return refused(trapped.error().message);
  auto child =
      host_->start(*plan_.server, [this](std::string_view line) { output_.read_line(line); });
  if (!child) return refused(child.error().message);
  child_ = std::move(*child);

  while (!has_open_port()) {
    const auto next = Clock::now() + kPortCheckInterval;
    while (Clock::now() < next) {
      if (!keep_waiting()) return std::nullopt;
      std::this_thread::sleep_for(kLogPollInterval);
    }
  }
  return std::nullopt;
}

std::string ExternalServer::waiting_for() const {
  if (!plan_.server) {
    return fmt::format("no soccer server answers at {}:{}", plan_.server_host, plan_.ports.player);
  }

  const std::vector<int> ports =
      child_ == nullptr ? std::vector<int>()
                        : process::ports_of(process::Protocol::kUdp, child_->status().pid);
  const std::string hint =
      ports.empty() ? "" : fmt::format(" (but port {})", fmt::join(ports, ", "));
  return fmt::format("the soccer server did not open UDP port {}{}", plan_.ports.player, hint);
}

std::string ExternalServer::monitor_address() const {
  if (!options_.monitor_port) return {};
  return fmt::format("{}:{}", plan_.server_host, plan_.ports.player);
}

void ExternalServer::wait_for_clients() { std::this_thread::sleep_for(kLogPollInterval); }

void ExternalServer::poll() {
  std::this_thread::sleep_for(kLogPollInterval);
  log_.poll();
}

bool ExternalServer::binds_clients() const {
  return plan_.server && options_.server_choice.kind == ServerChoice::Kind::kEmbedded;
}

// No client of another side can take the places of one behind a relay, unless both have one name.
bool ExternalServer::keeps_places(soccer::Side side) const {
  return binds_clients() || (relays_[side] != nullptr && !names_.collided(side));
}

// 0: it cannot be seen.
int ExternalServer::server_process() const {
  if (child_ != nullptr) return child_->status().pid;
  if (plan_.server_host != kLoopback && plan_.server_host != process::loopback_host()) return 0;
  const auto owners = process::owners_of(process::Protocol::kUdp, plan_.ports.player);
  return owners.empty() ? 0 : owners.front().pid;
}

// A program of a side may be a player or the coach of that side, and agents of cls are not programs
// of their own. More connections are monitors, or they are in the place of another side.
void ExternalServer::look_for_intruder() {
  constexpr int kClientsOfTeam = soccer::kPlayersPerTeam + 1;
  const int server = server_process();
  if (binds_clients() || intruder_ || server == 0) return;

  soccer::PerSide<int> connections;
  for (const process::SocketOwner& owner : owners_.peers_of(server)) {
    const soccer::Side side = side_of(owner);
    if (side != soccer::Side::kNeutral) ++connections[side];
  }

  for (const soccer::Side side : soccer::kBothSides) {
    const bool external = endpoint_of(options_, side).kind == Endpoint::Kind::kTeam;
    const int own = external ? kClientsOfTeam : 0;
    if (connections[side] <= own || intruder_) continue;
    intruder_ = Intruder{side, fmt::format("programs of the {} side hold {} connections to the "
                                           "soccer server; {} can be its own",
                                           side_name(side), connections[side], own)};
    warnings_.push_back("an intrusion: " + intruder_->evidence);
  }
}

std::optional<Intruder> ExternalServer::intruder() {
  look_for_intruder();
  return intruder_;
}

// Programs look at the connections when there are new ones only: that costs nothing in play.
std::vector<std::string> ExternalServer::take_warnings() {
  const ServerStatus status = output_.status();
  if (std::exchange(seen_connections_, status.connections) != status.connections) {
    look_for_intruder();
  }
  std::vector<std::string> lines = std::exchange(warnings_, {});
  const auto first = status.intrusions.begin() + static_cast<std::ptrdiff_t>(reported_intrusions_);
  reported_intrusions_ = status.intrusions.size();
  lines.insert(lines.end(), first, status.intrusions.end());
  for (const soccer::Side side : soccer::kBothSides) {
    if (relays_[side] == nullptr) continue;
    for (std::string& line : relays_[side]->take_warnings()) lines.push_back(std::move(line));
  }
  return lines;
}

SourceProgress ExternalServer::progress() const { return log_.progress(); }

// Agents see every cycle. Logs leave out the cycles before a kick-off, while the clock is stopped.
milliseconds ExternalServer::quiet_time() const {
  if (has_agents(options_)) return kLogPollInterval;

  const soccer::ServerParams& server = options_.server;
  milliseconds cycle(server.simulator_step * server.slow_down_factor);
  // Before the match programs load and warm up, and the server may wait for them in each cycle.
  const bool waits = mode_of(options_) != MatchMode::kRealtime && log_.progress().match.cycle == 0;
  if (waits) cycle = std::max(cycle, kServerWait);
  return cycle * (server.kick_off_wait + 1);
}

bool ExternalServer::finished() const {
  const MatchProgress& logged = log_.progress().match;
  return output_.status().game_over || logged.mode == soccer::PlayMode::kTimeOver ||
         (options_.cycles && logged.cycle >= *options_.cycles);
}

std::optional<MatchEnd> ExternalServer::failure(bool playing) {
  if (child_ == nullptr || !process::has_ended(child_->status())) return std::nullopt;
  log_.poll();
  if (finished()) return std::nullopt;

  const std::string exit = to_text(child_->status().exit.value_or(process::ProcessExit{}));
  const ServerStatus status = output_.status();
  const int cycle = log_.progress().match.cycle;
  if (status.gave_up) {
    return MatchEnd{
        .reason = EndReason::kLate,
        .message = fmt::format(
            "the soccer server gave up at cycle {}{}: clients stopped responding", cycle,
            cycle > kMaxMissed + 1 ? ""
                                   : " (a team without synchronous mode needs --mode realtime)"),
        .failure = failure_of(*child_)};
  }
  if (playing) {
    return MatchEnd{.reason = EndReason::kServerFailed,
                    .message = fmt::format("the soccer server ended at cycle {}: {}", cycle, exit),
                    .failure = failure_of(*child_)};
  }
  const std::string why =
      status.first_error.empty() ? "" : fmt::format(" ({})", status.first_error);
  return refused(fmt::format("the soccer server ended before the match: {}{}", exit, why));
}

void ExternalServer::finish(FinalState state, const std::atomic<int>& signal) {
  if (child_ == nullptr) return;

  left_over_ = state == FinalState::kOver;
  const auto until = Clock::now() + kExitTimeout;
  while (state == FinalState::kOver && !child_->wait_exit(kLogPollInterval) &&
         Clock::now() < until) {
    if (signal.load() != 0) break;
  }
  child_->end(kServerGrace);
  // No client may leave before the server: it would continue without them.
  if (state == FinalState::kHeld) child_->wait_gone(kServerGrace + kKillMargin);
}

std::vector<ProcessResult> ExternalServer::wait_gone() {
  if (child_ == nullptr) return {};
  child_->wait_gone(kServerGrace + kKillMargin);
  return {result_of(*child_)};
}

// What agents have heard counts for nothing: any program in their network can send to them in the
// name of the server. So there is no result without a log that has it.
void ExternalServer::report_unknown(MatchResult& result, bool has_agents,
                                    const std::string& why) const {
  if (!plan_.server || !result.valid()) return;
  result.end_reason = EndReason::kServerFailed;
  result.message = "the result is unknown: " + why;
  if (has_agents) {
    result.message +=
        fmt::format("; the cls agents heard {} : {}", result.left.score, result.right.score);
  }
  result.left.score = result.right.score = 0;
}

// An exit code of `cls server`; rcssserver does not report it.
void ExternalServer::report_write_error(MatchResult& result) const {
  const auto exit = child_ == nullptr ? std::nullopt : child_->status().exit;
  if (!exit || exit->by_signal || exit->number != kServerWriteError) return;
  constexpr std::string_view kMessage = "cls: ";
  std::string why = to_text(*exit);
  for (const std::string& line : child_->last_lines()) {
    if (line.starts_with(kMessage)) why = line.substr(kMessage.size());
  }
  result.write_error = "the soccer server could not write its logs: " + why;
}

// Such a log knows the result, whatever agents have heard. Only `cls server` says whether it could
// write.
bool ExternalServer::has_written_whole_log() const {
  if (child_ == nullptr || !binds_clients()) return false;
  const process::Child::Status status = child_->status();
  if (!status.exit) return false;
  return !status.exit->by_signal && status.exit->number != kServerWriteError;
}

// True if the log ends before the match: the disk was full, the file too large, or agents believed
// somebody that it is over. The players are a cycle ahead of the log when a match ends at its cycle
// limit.
bool ExternalServer::is_cut(int cycles, bool over, const std::vector<AgentProgress>& agents) const {
  const bool at_limit = options_.cycles && cycles + 1 >= *options_.cycles;
  if (left_over_ && !over && !at_limit) return true;
  if (has_written_whole_log()) return false;
  if (agents.empty()) return output_.status().game_over && !over && !at_limit;
  return std::ranges::any_of(agents, [cycles](const AgentProgress& seen) {
    return seen.progress.match.cycle > cycles + 1;
  });
}

// Why the log does not have the result; empty: it has.
std::string ExternalServer::why_unknown(const MatchResult& result,
                                        const gamelog::MatchRecord& record,
                                        const analysis::MatchSummary& summary,
                                        const std::vector<AgentProgress>& agents) const {
  constexpr int kLastCycles = 5;  // in real time the players are some cycles behind
  const int cycles = last_cycle(record, summary.cycles);
  for (const AgentProgress& seen : agents) {
    const MatchProgress& heard = seen.progress.match;
    const bool left = heard.mode == soccer::PlayMode::kTimeOver;
    if (!left || heard.cycle + kLastCycles >= cycles) continue;
    return fmt::format(
        "the players of {} left at cycle {} of {}, because somebody told them that "
        "the match is over",
        seen.team, heard.cycle, cycles);
  }

  const bool over = !record.mode.empty() && record.mode.back() == soccer::PlayMode::kTimeOver;
  if (!is_cut(cycles, over, agents)) return "";
  std::string why = fmt::format("{} ends at cycle {}", kGameLogFile, summary.cycles);
  if (!agents.empty()) why += fmt::format(" of {}", result.cycles);
  if (!result.write_error.empty()) why += fmt::format(" ({})", result.write_error);
  return why;
}

void ExternalServer::read_log(MatchResult& result, const std::vector<AgentProgress>& agents) const {
  const auto record = gamelog::read_rcg_file((folder_ / kGameLogFile).string());
  if (!record) return report_unknown(result, !agents.empty(), record.error().message);
  if (record->frames() == 0) {
    return report_unknown(result, !agents.empty(), "the game log contains no cycle");
  }

  const analysis::MatchSummary summary = analysis::summarize(*record, nullptr);
  for (const analysis::GoalSummary& goal : summary.goals) {
    result.goals.push_back({goal.cycle, goal.side, goal.own_goal ? 0 : goal.unum});
  }
  result.rcg = kGameLogFile;
  std::error_code code;
  if (std::filesystem::exists(folder_ / kTextLogFile, code)) result.rcl = kTextLogFile;
  report_write_error(result);

  if (result.valid()) {
    const std::string why = why_unknown(result, *record, summary, agents);
    if (!why.empty()) return report_unknown(result, !agents.empty(), why);
  }

  for (const soccer::Side side : soccer::kBothSides) {
    TeamResult& team = result.team(side);
    const auto& logged = summary.teams[soccer::side_index(side)];
    if (!logged.name.empty()) team.name = base::printable(logged.name);
    team.score = logged.score;
    team.penalty_score.reset();
    if (summary.penalties) team.penalty_score = logged.penalty_score;
  }
  result.cycles = last_cycle(*record, summary.cycles);
  result.steps = summary.frames;
  warn_of_other_scores(result, agents);
}

// Players that counted other goals than the log has.
void ExternalServer::warn_of_other_scores(MatchResult& result,
                                          const std::vector<AgentProgress>& agents) {
  for (const AgentProgress& seen : agents) {
    const MatchProgress& heard = seen.progress.match;
    const bool same =
        heard.left_score == result.left.score && heard.right_score == result.right.score;
    if (same || seen.progress.steps == 0 || !result.valid()) continue;

    result.warnings.push_back(fmt::format(
        "the log says {} : {}, but the players of {} counted {} : {}", result.left.score,
        result.right.score, seen.team, heard.left_score, heard.right_score));
  }
}

void ExternalServer::add_result(MatchResult& result,
                                const std::vector<AgentProgress>& agents) const {
  const ServerStatus status = output_.status();
  const bool embedded = options_.server_choice.kind == ServerChoice::Kind::kEmbedded;
  result.deterministic = false;
  result.server_version = embedded ? std::string(base::kVersion) : status.version;
  result.server_seed = status.seed;
  result.server_missed_cycles = status.missed_cycles;
  if (child_ != nullptr) result.server_cpu_seconds = child_->cpu_seconds();

  for (const AgentProgress& seen : agents) {
    const MatchProgress& heard = seen.progress.match;
    if (heard.cycle < result.cycles) continue;

    result.cycles = heard.cycle;
    result.steps = seen.progress.steps;
    result.left.score = heard.left_score;
    result.right.score = heard.right_score;
  }
  if (plan_.server) read_log(result, agents);
}

void write_events(EventRecorder& events, const std::filesystem::path& folder,
                  const MatchResult& result) {
  events.start({result.left.name, result.right.name}, result.seed);
  const auto record = gamelog::read_rcg_file((folder / kGameLogFile).string());
  events.read_log(record ? *record : gamelog::MatchRecord(), result);
  events.end(result);
}

}  // namespace cls::match
