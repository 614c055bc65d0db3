// Steps of the embedded server, and external teams that play on it over UDP.
#include "match/server/embedded_server.h"

#include <fmt/format.h>

#include <ctime>

#include "base/index.h"
#include "base/system/version.h"
#include "gamelog/rcg/rcg_writer.h"
#include "match/server/match_plan.h"
#include "match/server/server_logs.h"
#include "process/ports.h"
#include "process/socket_visibility.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;
using soccer::Side;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr int kStockPort = 6000;
constexpr milliseconds kJoinStep{20};  // length of a cycle while external teams join
constexpr milliseconds kCommandPollInterval{2};
constexpr milliseconds kLateCommandTimeout{2000};

// True if a match with the same seed may have the same bytes, so that its log has no date.
bool repeats(const MatchOptions& options) {
  return !has_external_team(options) && mode_of(options) != MatchMode::kRealtime;
}

}  // namespace

Result<std::unique_ptr<EmbeddedServer>> EmbeddedServer::create(const MatchOptions& options,
                                                               std::uint64_t seed) {
  TRY_INIT(auto server, simulator::LockstepServer::create(server_config(options, seed)));
  std::unique_ptr<EmbeddedServer> created(new EmbeddedServer(options));
  created->server_ = std::move(server);
  return created;
}

void EmbeddedServer::record(base::ByteSink* game_log, base::ByteSink* text_log,
                            EventRecorder* events) {
  simulator::LogSinks sinks{game_log, text_log};
  if (!repeats(options_)) sinks.date = log_date(std::time(nullptr));
  sinks.version = gamelog::rcg_version(options_.server.game_log_version).value_or(sinks.version);
  server_->record(sinks);
  events_ = events;
}

void EmbeddedServer::bind_clients() {
  if (binding_ || !options_.bind_clients) return;
  if (auto missing = process::missing_socket_owners(); !missing.empty()) {
    warnings_.push_back(std::move(missing));
    return;
  }

  binding_.emplace(bound_sides(), process::SocketOwners::of_own_programs());
  server_->bind_clients(
      [this](const base::SocketAddress& sender) { return binding_->rights_of(sender); },
      [this](const base::SocketAddress& sender, std::string_view request) {
        if (auto line = binding_->intrusion_line(sender, request)) {
          warnings_.push_back(*std::move(line));
        }
      });
}

Result<ServerPorts> EmbeddedServer::open_player_port(bool free_port) {
  const auto port = server_->open_player_port(kLoopback, free_port ? 0 : kStockPort);
  if (port) bind_clients();
  if (port) return ServerPorts{*port, *port + 1, *port + 2};
  if (free_port) return port.error();

  return Error{fmt::format("{}: a team whose start script takes no ports needs it",
                           process::port_taken_text(process::Protocol::kUdp, kStockPort))};
}

// Whose clients come there needs no other evidence.
Result<ServerPorts> EmbeddedServer::open_player_port_in(
    std::shared_ptr<const process::Namespaces> namespaces, Side side) {
  namespaces_[side] = std::move(namespaces);
  if (!side_binding_) side_binding_.emplace(bound_sides(), std::nullopt);
  const simulator::OtherNetwork network =
      network_of(side, *side_binding_, namespaces_[side]->door(),
                 [this](std::string line) { warnings_.push_back(std::move(line)); });
  const ServerPorts ports;
  TRY(server_->open_player_port_in(network, kLoopback, ports.player));
  return ports;
}

std::optional<MatchEnd> EmbeddedServer::start(const std::function<bool()>& /*keep_waiting*/) {
  if (!options_.monitor_port) return std::nullopt;

  const auto port = server_->open_monitor_port(kLoopback, *options_.monitor_port);
  if (!port) {
    const std::string taken =
        process::taken_port(process::Protocol::kUdp, {*options_.monitor_port});
    if (taken.empty()) {
      return MatchEnd{.reason = EndReason::kServerFailed, .message = port.error().message};
    }
    return MatchEnd{
        .reason = EndReason::kRefused, .message = "--monitor-port: " + taken, .try_again = true};
  }

  bind_clients();
  monitor_address_ = fmt::format("{}:{}", kLoopback, *port);
  return std::nullopt;
}

// External players that get no messages would take the server for dead, so cycles pass; but the
// match does not kick off before all players are there.
void EmbeddedServer::wait_for_clients() {
  constexpr int kNoKickOff = 1'000'000;
  if (!has_external_team()) return;
  set_kick_off_wait(kNoKickOff);
  server_->run_cycle();
  server_->receive_until(Clock::now() + kJoinStep);
}

void EmbeddedServer::set_kick_off_wait(int cycles) {
  server_->modify_world([cycles](simulator::World& world, simulator::Events&) {
    world.auto_mode.kick_off_wait = world.auto_mode.connect_wait = cycles;
    world.clock.stoppage = 0;  // the time it took to join must not show in the match
  });
}

ServerStatus EmbeddedServer::status() const {
  ServerStatus status;
  const simulator::World& world = server_->world();
  for (const Side side : soccer::kBothSides) {
    if (world.team(side).name.empty()) continue;

    ReportedConnections& team = status.teams.emplace_back();
    team.name = world.team(side).name.view();
    for (const simulator::Player& player : world.players) {
      if (player.side == side && player.joined) team.players.insert(player.unum);
    }
  }
  return status;
}

// A player that still computes its reply to an earlier cycle must not be late for the first one.
void EmbeddedServer::drain_late_commands() {
  const auto deadline = Clock::now() + kLateCommandTimeout;
  const auto awaits_external_player = [this] {
    for (const simulator::Player& player : server_->world().players) {
      if (external_[player.side] && server_->awaits(player.slot())) return true;
    }
    return false;
  };

  while (awaits_external_player() && Clock::now() < deadline) {
    server_->receive_until(Clock::now() + kCommandPollInterval);
  }
  server_->discard_commands();
}

void EmbeddedServer::begin_play(const std::vector<Arrange>& arrange) {
  for (const Arrange& change : arrange) server_->modify_world(change);
  playing_ = true;
  if (!has_external_team()) return;

  drain_late_commands();
  set_kick_off_wait(server_->world().params().kick_off_wait);
  for (const simulator::Player& player : server_->world().players) {
    must_stay_[base::index(player.slot())] = external_[player.side] && player.enabled;
  }
}

void EmbeddedServer::step(const Arrange& after_step) {
  if (branch_ && branch_->steps == steps_) {
    server_->modify_world([seed = branch_->seed](simulator::World& world, simulator::Events&) {
      world.seed = seed;
      world.random = simulator::RandomStreams(seed);
    });
  }
  server_->run_cycle(after_step);
  ++steps_;
  if (events_ != nullptr) events_->follow(server_->world());
}

bool EmbeddedServer::wait_for_commands(milliseconds limit) {
  return !has_external_team() || server_->wait_for_clients(Clock::now() + limit);
}

// Players that have left the pitch may disconnect: many clients do so without messages.
std::optional<int> EmbeddedServer::lost_player(Side side) {
  for (int unum = 1; playing_ && unum <= soccer::kPlayersPerTeam; ++unum) {
    const int slot = soccer::slot_of(side, unum);
    bool& must_stay = must_stay_[base::index(slot)];
    if (!must_stay) continue;

    if (!server_->is_connected(slot)) return unum;
    must_stay = server_->world().player(slot).enabled;
  }
  return std::nullopt;
}

SourceProgress EmbeddedServer::progress() const {
  const simulator::World& world = server_->world();
  return {{world.clock.time, 0, world.team(Side::kLeft).score, world.team(Side::kRight).score,
           world.mode},
          steps_};
}

void EmbeddedServer::add_result(MatchResult& result,
                                const std::vector<AgentProgress>& /*agents*/) const {
  const simulator::World& world = server_->world();

  // When --cycles cuts a shoot-out, one team may not have kicked yet.
  const bool shoot_out =
      world.team(Side::kLeft).penalty_kicks + world.team(Side::kRight).penalty_kicks > 0;
  for (const Side side : soccer::kBothSides) {
    const simulator::Team& team = world.team(side);
    TeamResult& reported = result.team(side);
    reported.score = team.score;
    if (shoot_out) reported.penalty_score = team.penalty_goals;
  }

  if (has_external_team()) result.deterministic = false;
  result.cycles = world.clock.time;
  result.steps = steps_;
  result.server_version = base::kVersion;
  result.server_missed_cycles = missed_cycles_;
  if (events_ != nullptr) result.goals = events_->goals();
}

}  // namespace cls::match
