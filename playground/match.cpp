// Server and teams in turns, as in a match in lockstep.
#include "playground/match.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "gamelog/rcg/rcg_writer.h"
#include "mock-server/script/named_behaviors.h"
#include "soccer/parameters/match_parameters.h"

namespace cls::playground {
namespace {

using base::Error;
using base::Result;
using soccer::Side;

/// The behavior of a bundled team, empty for the default one; nothing for another side.
std::optional<std::string_view> behavior_of(std::string_view side) {
  if (side == kMockSide) return "";
  if (!side.starts_with(kMockSide) || side[kMockSide.size()] != ':') return std::nullopt;
  return side.substr(kMockSide.size() + 1);
}

Result<simulator::MatchConfig> config_of(const MatchSetup& setup) {
  simulator::MatchConfig config;
  config.server = soccer::match_server_params();
  for (const std::string& setting : setup.settings) {
    TRY(soccer::apply_setting(config.server, config.player, setting));
  }
  config.server.auto_mode = true;
  // Players must not notice how logs are stored.
  config.server.game_log_compression = config.server.text_log_compression = 0;
  config.seed = setup.seed;
  if (setup.book == nullptr) {
    config.cycle_limit = setup.cycles;
  } else {
    config.types = analysis::log_of(*setup.book, setup.seed, setup.situations).types;
    config.player.player_types = static_cast<int>(config.types.size());
  }
  return config;
}

bool has_text_log(gamelog::RcgVersion version) {
  return version >= gamelog::RcgVersion::kV4 && version <= gamelog::RcgVersion::kV6;
}

}  // namespace

Result<std::unique_ptr<Match>> Match::create(const MatchSetup& setup, Functions functions) {
  TRY_INIT(const auto names, team_names(setup));
  std::unique_ptr<Match> match(new Match(setup.view));
  TRY(match->open_server(setup));
  for (const Side side : soccer::kBothSides) {
    TRY(match->add_team(side, setup, names[side], std::move(functions[side])));
  }
  for (const Side side : soccer::kBothSides) TRY(match->connect(side));
  for (const Side side : soccer::kBothSides) {
    const proxy::RpcStatus status = match->sides_[side].team->register_agents();
    if (!status.ok()) return Error{fmt::format("{}: {}", names[side], status.message)};
  }
  if (setup.book != nullptr) match->begin_situations(setup);
  return match;
}

Result<void> Match::open_server(const MatchSetup& setup) {
  TRY_INIT(const auto config, config_of(setup));
  TRY_INIT(server_, simulator::LockstepServer::create(config));

  simulator::LogSinks sinks;
  if (config.server.game_logging) sinks.game = &game_log_;
  if (config.server.text_logging) sinks.text = &text_log_;
  sinks.version = gamelog::rcg_version(config.server.game_log_version).value_or(sinks.version);
  if (with_view_) {
    if (!config.server.game_logging || !has_text_log(sinks.version)) {
      return Error{"'view' needs a game log of version 4 to 6 (server::game_log_version)"};
    }
    game_log_.copy_to(view_);
  }
  server_->record(sinks);
  return {};
}

Result<void> Match::add_team(Side side, const MatchSetup& setup, const std::string& name,
                             proxy::FallibleHandler function) {
  TeamSide& added = sides_[side];
  const std::string_view who = setup.sides[side];
  if (who == kFunctionSide) {
    if (!function) return Error{fmt::format("side '{}' has no function", who)};
    added.playmaker = proxy::make_fallible_playmaker(std::move(function));
  } else if (const auto behavior = behavior_of(who)) {
    TRY_INIT(added.behavior, mock_server::make_behavior(*behavior));
    added.mock = std::make_unique<mock_server::RequestHandler>(*added.behavior, nullptr);
    added.playmaker = proxy::make_direct_playmaker(
        [mock = added.mock.get()](proto::Rpc rpc, const google::protobuf::Message& request,
                                  google::protobuf::Message& reply) {
          mock->handle(rpc, request, reply);
        });
  } else {
    return Error{
        fmt::format("unknown side '{}': must be mock, mock:NAME or {}; other sides need "
                    "`cls match`",
                    who, kFunctionSide)};
  }

  proxy::TeamOptions options;
  options.name = soccer::TeamName(name);
  added.team = std::make_unique<proxy::Team>(options, *added.playmaker);
  if (setup.decisions) {
    added.decisions = std::make_unique<match::DecisionStream>(side, name);
    added.team->listen_to_decisions(*added.decisions);
  }
  return {};
}

Result<void> Match::connect(Side side) {
  simulator::ClientRights rights;
  rights.left = side == Side::kLeft;
  rights.right = side == Side::kRight;
  const auto open = [&](simulator::ListeningPort port) {
    return [this, rights, port] { return server_->connect(port, rights); };
  };
  const auto serve = [this] {
    server_->accept_clients();
    return true;
  };

  proxy::Team& team = *sides_[side].team;
  TRY(team.connect(open(simulator::ListeningPort::kPlayers), serve));
  return team.connect_coach(soccer::CoachRole::kOnlineCoach,
                            open(simulator::ListeningPort::kOnlineCoaches), serve);
}

void Match::begin_situations(const MatchSetup& setup) {
  book_ = setup.book;
  situations_.emplace(*book_, setup.seed, setup.situations, *setup.cycles);
  server_->modify_world([this](simulator::World& world, simulator::Events& events) {
    situations_->begin(world, events);
  });
}

bool Match::play(int steps) {
  for (int i = 0; i < steps && !over_; ++i) {
    play_step();
    if (is_over()) finish();
  }
  return !over_;
}

bool Match::is_over() const {
  return server_->finished() || !failure_.empty() || (situations_ && situations_->over());
}

void Match::play_step() {
  server_->run_cycle([this](simulator::World& world, simulator::Events& events) {
    if (!situations_ || situations_->over()) return;
    situations_->after_step(world);
    if (situations_->ended()) situations_->next(world, events);
  });
  for (const Side side : soccer::kBothSides) {
    TeamSide& playing = sides_[side];
    playing.team->run_cycle();
    if (playing.decisions) playing.decisions->end_cycle(playing.decision_bytes);
  }

  for (const Side side : soccer::kBothSides) {
    const proxy::Team& team = *sides_[side].team;
    const proxy::MissedDecisions missed = team.missed_decisions();
    if (missed.consecutive <= kMaxMissed || !failure_.empty()) continue;
    failure_ = fmt::format("{}: {} had no usable reply to {} calls in a row, at cycle {}: {}",
                           team.name(), proxy::agent_name(missed.unum), missed.consecutive,
                           world().clock.time, missed.last.message);
  }
}

void Match::finish() {
  server_->finish();
  over_ = true;
  for (const Side side : soccer::kBothSides) end_team(sides_[side]);
}

void Match::end_team(TeamSide& side) {
  side.team->leave();
  if (side.decisions) side.decisions->end(side.decision_bytes);
}

std::string Match::take_view() { return with_view_ ? view_.take(over_) : std::string(); }

std::string Match::take_decisions(Side side) {
  return std::exchange(sides_[side].decision_bytes, {});
}

std::vector<std::string> Match::take_warnings() {
  std::vector<std::string> all;
  for (const Side side : soccer::kBothSides) {
    proxy::Team& team = *sides_[side].team;
    for (const std::string& line : team.take_warnings()) {
      all.push_back(fmt::format("{}: {}", team.name(), line));
    }
  }
  return all;
}

}  // namespace cls::playground
