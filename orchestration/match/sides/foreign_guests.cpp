// Joining, answering and leaving of foreign teams beside agents of ours.
#include "orchestration/match/sides/foreign_guests.h"

#include <fmt/format.h>

#include <thread>
#include <utility>

#include "orchestration/match/sides/playmaker_program.h"
#include "orchestration/process/ports.h"

namespace cls::orchestration::match {
namespace {

using base::Error;
using base::Result;
using soccer::Side;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr const char* kHost = "127.0.0.1";
constexpr int kStockPort = 6000;
constexpr milliseconds kMoment{20};
constexpr milliseconds kGlance{2};
constexpr milliseconds kLastAnswers{2000};
constexpr milliseconds kEndBecomesKnown{500};
constexpr milliseconds kGrace{1000};
constexpr milliseconds kKillMargin{1000};

// What a server of its own would have printed about them.
ServerNews news_of(const simulator::World& world) {
  ServerNews news;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (world.team(side).name.empty()) continue;
    AnnouncedTeam& team = news.teams.emplace_back();
    team.name = world.team(side).name.view();
    for (const simulator::Player& player : world.players) {
      if (player.side == side && player.joined) team.players.insert(player.unum);
    }
  }
  return news;
}

TeamValues values_of(Side side, const MatchOptions& options, const TeamNames& names,
                     const ServerPorts& ports, const std::filesystem::path& folder) {
  const bool left = side == Side::kLeft;
  TeamValues values;
  values.host = kHost;
  values.ports = ports;
  values.side = side;
  values.team_name = left ? names.left : names.right;
  values.coach = false;
  values.folder = folder;
  values.cpus = left ? options.left_cpus : options.right_cpus;
  return values;
}

// A connection is closed a moment before the end of its process is known.
const process::Child* dead_agent_soon(const ForeignTeam& team) {
  const bool each = team.plan().contract == TeamPlan::Contract::kStartEachAgent;
  const auto until = Clock::now() + kEndBecomesKnown;
  while (each && team.dead_agent() == nullptr && Clock::now() < until) {
    std::this_thread::sleep_for(kGlance);
  }
  return team.dead_agent();
}

// True for the process of that player alone (see team_plan).
bool is_of(const process::Child& agent, int unum) {
  return agent.plan().name.ends_with(fmt::format(" player {}", unum));
}

}  // namespace

Result<std::unique_ptr<ForeignGuests>> ForeignGuests::create(const MatchOptions& options,
                                                             const TeamNames& names,
                                                             simulator::LockstepServer& server,
                                                             process::ProcessHost& host,
                                                             const std::filesystem::path& folder) {
  std::unique_ptr<ForeignGuests> guests(new ForeignGuests(server));
  std::vector<std::pair<Side, std::string>> foreign;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Endpoint& endpoint = side == Side::kLeft ? options.left : options.right;
    if (endpoint.kind == Endpoint::Kind::kTeam) foreign.emplace_back(side, endpoint.path);
  }
  if (foreign.empty()) return std::unique_ptr<ForeignGuests>();
  // A start script that knows no ports decides which one it is.
  ServerPorts ports;
  bool takes_ports = true;
  for (const auto& [side, path] : foreign) {
    const auto plan = team_plan(path, values_of(side, options, names, ports, folder));
    if (!plan) return plan.error();
    takes_ports = takes_ports && plan->takes_ports;
  }
  const auto opened = server.open_to_players(kHost, takes_ports ? 0 : kStockPort);
  if (!opened && takes_ports) return opened.error();
  if (!opened) {
    return Error{fmt::format("{}: a team whose start script knows no ports needs it",
                             process::port_taken_text(process::Protocol::kUdp, kStockPort))};
  }
  ports = {*opened, *opened + 1, *opened + 2};
  for (const auto& [side, path] : foreign) {
    auto plan = team_plan(path, values_of(side, options, names, ports, folder));
    if (!plan) return plan.error();
    guests->teams_[index(side)] = std::make_unique<ForeignTeam>(*std::move(plan), host);
  }
  return guests;
}

Result<void> ForeignGuests::join(Side side) {
  std::vector<std::string> others;
  if (side == Side::kRight) others.emplace_back(server_.world().team(Side::kLeft).name.view());
  return team(side).join(news_of(server_.world()), others);
}

// No kick-off yet, whoever is there.
void ForeignGuests::pass_time() {
  constexpr int kForEver = 1'000'000;
  set_kick_off_wait(kForEver);
  server_.run_cycle();
  server_.receive_until(Clock::now() + kMoment);
}

void ForeignGuests::set_kick_off_wait(int cycles) {
  server_.arrange([cycles](simulator::World& world, simulator::Events&) {
    world.auto_mode.kick_off_wait = world.auto_mode.connect_wait = cycles;
    world.clock.stoppage = 0;  // how long they took to come must not be seen in the match
  });
}

// Whoever is still thinking about what was before must not be late for the first cycle.
void ForeignGuests::forget_the_past() {
  const auto deadline = Clock::now() + kLastAnswers;
  const auto thinking = [this] {
    for (const simulator::Player& player : server_.world().players) {
      if (has(player.side) && server_.awaits(player.slot())) return true;
    }
    return false;
  };
  while (thinking() && Clock::now() < deadline) server_.receive_until(Clock::now() + kGlance);
  server_.forget_commands();
}

void ForeignGuests::begin() {
  playing_ = true;
  forget_the_past();
  set_kick_off_wait(server_.world().params().kick_off_wait);
  for (const simulator::Player& player : server_.world().players) {
    plays_[static_cast<std::size_t>(player.slot())] = has(player.side) && player.enabled;
  }
}

bool ForeignGuests::answered(simulator::LockstepServer::Time deadline) {
  return server_.wait_for_answers(deadline);
}

std::optional<ForeignGuests::Loss> ForeignGuests::loss() {
  const auto told = [](Side side, const process::Child& child) {
    ProcessFailure failure = failure_of(child);
    std::string what = fmt::format("the process of {} ended: {}", child.plan().name, failure.exit);
    return Loss{side, std::move(what), std::move(failure)};
  };
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const process::Child* dead = playing_ || !has(side) ? nullptr : team(side).dead_agent();
    if (dead != nullptr) return told(side, *dead);
  }
  // Who is not on the pitch may go: many clients do when a server has nothing to tell them.
  for (std::size_t slot = 0; playing_ && slot < plays_.size(); ++slot) {
    const auto id = static_cast<int>(slot);
    if (!plays_[slot]) continue;
    const Side side = soccer::side_of_slot(id);
    const int unum = soccer::unum_of_slot(id);
    if (server_.is_connected(id)) {
      plays_[slot] = server_.world().player(id).enabled;
      continue;
    }
    if (const process::Child* dead = dead_agent_soon(team(side));
        dead != nullptr && is_of(*dead, unum)) {
      return told(side, *dead);
    }
    return Loss{side, fmt::format("player {} has left", unum), std::nullopt};
  }
  return std::nullopt;
}

void ForeignGuests::end() {
  for (const auto& team : teams_) {
    if (team != nullptr) team->call_kill_script();
  }
  for (const auto& team : teams_) {
    if (team != nullptr) team->end(kGrace);
  }
  for (const auto& team : teams_) {
    if (team != nullptr) team->wait_gone(kGrace + kKillMargin);
  }
}

std::vector<ProcessResult> ForeignGuests::results() const {
  std::vector<ProcessResult> all;
  for (const auto& team : teams_) {
    if (team == nullptr) continue;
    for (ProcessResult& one : team->results()) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace cls::orchestration::match
