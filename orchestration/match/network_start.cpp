// Starting programs, and joining a match step by step.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "orchestration/match/network_match.h"
#include "orchestration/match/sides/playmaker_link.h"
#include "orchestration/match/sides/playmaker_program.h"

namespace cls::orchestration::match {
namespace {

using std::chrono::milliseconds;
using Clock = DeadlineWatch::Clock;

constexpr milliseconds kPortLook{30};

}  // namespace

void NetworkMatch::start_sides() {
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    Side& side = sides_[i];
    if (i < plan_.teams.size() && plan_.teams[i]) {
      side.foreign = std::make_unique<ForeignTeam>(std::move(*plan_.teams[i]), host_);
      continue;
    }
    SideSetup setup;
    setup.side = side_of(side);
    setup.name = side.name;
    setup.seed = seed_;
    setup.folder = folder_;
    setup.host = &host_;
    if (i < 2) setup.cpus = i == 0 ? options_.left_cpus : options_.right_cpus;
    auto created = MatchSide::create(endpoint_of(i), setup, options_);
    if (!created) return end(EndReason::kRefused, created.error().message);
    // Our own server counts the cycles itself.
    const bool embedded = options_.server_choice.kind == ServerChoice::Kind::kEmbedded;
    const bool counts = !embedded && i < 2;
    auto own = OwnTeam::create(std::move(*created), plan_.server_host, plan_.ports, options_,
                               counts ? options_.cycles : std::nullopt);
    if (!own) return end(EndReason::kRefused, own.error().message);
    side.own = std::move(*own);
  }
}

// A Playmaker that needs long to start must not make the players on the pitch wait for it.
void NetworkMatch::wait_for_playmakers(MatchObserver& observer) {
  for (Side& side : sides_) {
    if (ended() || !side.own || side.own->side().program() == nullptr) continue;
    const PlaymakerProgram& program = *side.own->side().program();
    observer.on_phase(fmt::format("waiting for {}", side.own->who()));
    wait_until(
        [&] { return process::tcp_answers("localhost", program.port(), 100); },
        [&] { return fmt::format("{}: no answer{}", side.own->who(), program.port_hint()); });
    if (ended() && !end_->failure && end_->reason == EndReason::kRefused) {
      end_->failure = failure_of(program.child());
    }
  }
}

void NetworkMatch::start_server(MatchObserver& observer) {
  if (ended()) return;
  if (!plan_.server) return wait_for_address(observer);
  observer.on_phase("starting the soccer server");
  auto started =
      host_.start(*plan_.server, [this](std::string_view line) { output_.read_line(line); });
  if (!started) return end(EndReason::kRefused, started.error().message);
  server_ = std::move(*started);
  auto next_look = Clock::now();
  const auto bound = [&] {
    if (Clock::now() < next_look) return false;
    next_look = Clock::now() + kPortLook;
    const std::vector<int> ports =
        process::ports_of(process::Protocol::kUdp, server_->status().pid);
    return std::find(ports.begin(), ports.end(), plan_.ports.player) != ports.end();
  };
  const auto what = [&] {
    const std::vector<int> ports =
        process::ports_of(process::Protocol::kUdp, server_->status().pid);
    const std::string hint =
        ports.empty() ? "" : fmt::format(" (but port {})", fmt::join(ports, ", "));
    return fmt::format("the soccer server did not open UDP port {}{}", plan_.ports.player, hint);
  };
  if (!wait_until(bound, what) && end_->reason == EndReason::kRefused && !end_->failure) {
    end_->failure = failure_of(*server_);
  }
}

void NetworkMatch::wait_for_address(MatchObserver& observer) {
  const std::string where = fmt::format("{}:{}", plan_.server_host, plan_.ports.player);
  observer.on_phase(fmt::format("waiting for the soccer server at {}", where));
  auto clients = soccer::UdpClients::create(plan_.server_host, plan_.ports.player);
  if (!clients) return end(EndReason::kRefused, clients.error().message);
  waiting_for_ = [&] { return fmt::format("no soccer server answers at {}", where); };
  proxy::wait_for_server(**clients, [&] {
    check();
    return !ended();
  });
  waiting_for_ = {};
}

void NetworkMatch::join(std::size_t index, MatchObserver& observer) {
  if (ended()) return;
  Side& side = sides_[index];
  observer.on_phase(fmt::format("{} joins", side.own ? side.own->side().name() : side.name));
  if (side.foreign) return join_foreign(side, observer);
  side.own->start();
  wait_until([&] { return side.own->stage() > OwnTeam::Stage::kJoining; },
             [&] { return fmt::format("{} could not join the match", side.own->who()); });
}

void NetworkMatch::join_foreign(Side& side, MatchObserver& observer) {
  ForeignTeam& team = *side.foreign;
  std::vector<std::string> others;
  if (&side == &sides_[1]) others.push_back(team_name(0));
  const auto joined = [&] {
    const auto step = team.join(output_.news(), others);
    if (!step) {
      end(EndReason::kRefused, fmt::format("{}: {}", side.endpoint, step.error().message),
          team.latest_agent());
    }
    return team.joined();
  };
  const auto what = [&] {
    return fmt::format("{} ({}): {}", side.name, side.endpoint, team.waiting_for());
  };
  if (wait_until(joined, what)) return check_name(side, observer);
  if (end_->reason == EndReason::kRefused && !end_->failure && team.latest_agent() != nullptr) {
    end_->failure = failure_of(*team.latest_agent());
  }
}

void NetworkMatch::check_name(const Side& side, MatchObserver& observer) {
  const std::string& told = side.foreign->name();
  if (told == side.name) return;
  const std::string what = fmt::format("{}: the team plays under the name {} instead of {}",
                                       side.endpoint, told, side.name);
  if (side.name_is_asked_for) {
    end(EndReason::kRefused, what);
  } else if (side.foreign->plan().takes_name) {
    warn(observer, what);
  }
}

// The server takes players of the same team name for one team, and refuses the twelfth.
std::string NetworkMatch::name_hint(const Side& side) const {
  const bool unseen = &side == &sides_[1] && side.foreign && side.foreign->name().empty();
  if (!unseen || output_.news().teams.empty()) return "";
  return fmt::format("; or it plays under the name {} too", team_name(0));
}

std::string NetworkMatch::team_name(std::size_t index) const {
  const Side& side = sides_[index];
  return side.foreign && !side.foreign->name().empty() ? side.foreign->name() : side.name;
}

void NetworkMatch::introduce(MatchObserver& observer) {
  for (Side& side : sides_) {
    if (ended() || !side.own) continue;
    observer.on_phase(fmt::format("waiting for {}", side.own->who()));
    wait_until([&] { return side.own->stage() > OwnTeam::Stage::kIntroducing; },
               [&] {
                 return fmt::format("{}: no answer{}", side.own->who(),
                                    silence_hint(side.own->side().endpoint()));
               });
  }
}

}  // namespace cls::orchestration::match
