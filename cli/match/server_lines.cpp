// Status lines of `cls server`: connections, kick-offs, waits of auto mode.
#include "cli/match/server_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace cls::cli {
namespace {

using simulator::ClientId;
using simulator::UdpServerEvent;
using simulator::World;
using soccer::PlayMode;
using soccer::Side;

std::string_view team_name(const World& world, Side side) { return world.team(side).name.view(); }

// "TA 1"
std::string player_name(const World& world, ClientId client) {
  return fmt::format("{} {}", team_name(world, soccer::side_of_slot(client)),
                     soccer::unum_of_slot(client));
}

Side coach_side(ClientId client) {
  return client == simulator::kLeftCoach ? Side::kLeft : Side::kRight;
}

// True when the counter has just left its start value.
bool started(int now, int before, int start) {
  return now != before && now == std::max(start, 0) - 1;
}

}  // namespace

void ServerLines::event(const UdpServerEvent& event) {
  switch (event.kind) {
    case UdpServerEvent::Kind::kMissedCycle:
      fmt::print(stderr, "Someone missed a cycle at {}\n", server_.world().clock.time);
      return;
    case UdpServerEvent::Kind::kConnected:
      connected(event);
      break;
    case UdpServerEvent::Kind::kDisconnected:
      disconnected(event.client);
      break;
  }
  std::fflush(stdout);
}

void ServerLines::connected(const UdpServerEvent& event) {
  const World& world = server_.world();
  const ClientId client = event.client;

  const std::string version = fmt::format("(v{})", event.version);

  if (simulator::is_player(client)) {
    const auto slot = static_cast<std::size_t>(client);
    const std::string name = player_name(world, client);
    if (known_[slot]) {
      fmt::print("A player ({}) reconnected.\n", name);
    } else {
      fmt::print("A new {} player ({}) connected.\n", version, name);
    }
    known_[slot] = true;
  } else if (client == simulator::kTrainer) {
    fmt::print("A new {} offline coach connected\n", version);
  } else if (simulator::is_monitor(client)) {
    fmt::print("A new {} monitor connected.\n", event.version < 0 ? "(json)" : version);
  } else {
    fmt::print("A new {} online coach ({}) connected.\n", version,
               team_name(world, coach_side(client)));
  }
}

void ServerLines::disconnected(ClientId client) {
  const World& world = server_.world();
  if (simulator::is_player(client)) {
    fmt::print("A player disconnected : ({})\n", player_name(world, client));
  } else if (client == simulator::kTrainer) {
    fmt::print("An offline coach disconnected\n");
  } else if (simulator::is_monitor(client)) {
    fmt::print("A monitor disconnected\n");
  } else {
    const Side side = coach_side(client);
    const std::string& coach = server_.coach_name(side);
    fmt::print("An online coach disconnected : ({}{}{})\n", team_name(world, side),
               coach.empty() ? "" : " ", coach);
  }
}

void ServerLines::step(const World& world) {
  if (mode_ == PlayMode::kBeforeKickOff && world.mode != mode_) {
    if (world.mode == PlayMode::kKickOffLeft) fmt::print("Kick_off_left\n");
    if (world.mode == PlayMode::kKickOffRight) fmt::print("Kick_off_right\n");
    std::fflush(stdout);
  }
  mode_ = world.mode;
  const soccer::ServerParams& params = world.params();
  if (!params.auto_mode) return;

  const simulator::AutoMode& now = world.auto_mode;
  const char* line = nullptr;
  if (mode_ == PlayMode::kTimeOver) {
    if (started(now.game_over_wait, waits_.game_over_wait, params.game_over_wait)) {
      line = "Waiting after end of match\n";
    }
  } else if (started(now.connect_wait, waits_.connect_wait, params.connect_wait)) {
    line = "Waiting for players to connect\n";
  } else if (started(now.kick_off_wait, waits_.kick_off_wait, params.kick_off_wait)) {
    line = "Waiting to kick off\n";
  }

  waits_ = now;
  if (line == nullptr) return;
  fmt::print("{}", line);
  std::fflush(stdout);
}

}  // namespace cls::cli
