// Handshakes and the cycle of the match server: commands, step, senses, think.
#include "simulator/sessions/match_server.h"

#include <array>
#include <cstdlib>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include "simulator/actions/actions.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"
#include "soccer/commands/connection_request.h"

namespace cls::simulator {
namespace {

using soccer::ErrorCode;

// Initial capacities, so that a cycle does not allocate.
constexpr std::size_t kRefereeMessageCapacity = 64;  // bytes
constexpr std::size_t kEventCapacity = 64;

// First version of players that must not send commands to the listening port.
constexpr int kFirstStrictPlayerVersion = 8;

/// Share of cycles with late coaches. rcssserver sends (think) to coaches last, and they answer
/// fast: in 60 matches of helios-base they knew of 8 of 147 fouls in the cycle of the foul, and
/// made 3.0 of 6 substitutions that depend on a message of the same cycle. This share gives the
/// same numbers here.
constexpr double kLateCoachesShare = 1.0 / 16.0;

// Accepts the versions of gamelog::MonitorVersion, truncated to integers as in rcssserver; else 0.
int monitor_version(double version) {
  return version > -2.0 && version < 6.0 ? static_cast<int>(version) : 0;
}

bool may_use_listening_port(const Connection& client) {
  return is_monitor(client.client) ? client.version == kLenientMonitorVersion
                                   : client.version < kFirstStrictPlayerVersion;
}

// A session with a name of its own names teams as it sees them; the world knows other names.
void use_sides(const World& world, const PlayerSession& session, soccer::TeamReference& team) {
  using Kind = soccer::TeamReference::Kind;
  if (team.kind != Kind::kNamed) return;
  const Side own = world.player(session.slot()).side;
  if (session.own_name.view() == team.name) {
    team.kind = Kind::kOur;
  } else if (visible_team_name(world, own, opponent(own), session.own_name).view() == team.name) {
    team.kind = Kind::kOpponent;
  }
}

soccer::PlayerCommand with_sides(const World& world, const PlayerSession& session,
                                 const soccer::PlayerCommand& command) {
  soccer::PlayerCommand changed = command;
  if (auto* attention = std::get_if<soccer::AttentionTo>(&changed)) {
    use_sides(world, session, attention->team);
  } else if (auto* ear = std::get_if<soccer::Ear>(&changed); ear != nullptr && ear->team) {
    use_sides(world, session, *ear->team);
  }
  return changed;
}

}  // namespace

base::Result<std::unique_ptr<MatchServer>> MatchServer::create(const MatchConfig& config) {
  TRY_INIT(auto rules, config.types.empty()
                           ? make_rules(config.server, config.player, config.seed)
                           : make_rules(config.server, config.player, config.types));
  return std::unique_ptr<MatchServer>(new MatchServer(std::move(rules), config));
}

MatchServer::MatchServer(std::shared_ptr<const Rules> rules, const MatchConfig& config)
    : world_(make_world(rules, config.seed)),
      players_(rules->server),
      coaches_(rules->server),
      cycle_limit_(config.cycle_limit),
      decisive_lead_(config.decisive_lead) {
  referee_message_.text.reserve(kRefereeMessageCapacity);
  events_.reserve(kEventCapacity);
}

void MatchServer::record(const LogSinks& sinks) { recorder_.begin(sinks, *world_.rules); }

AdmissionResult MatchServer::admit(ListeningPort port, std::string_view datagram,
                                   const ClientRights& rights) {
  if (port == ListeningPort::kOnlineCoaches || port == ListeningPort::kTrainers) {
    return coaches_.admit(world_, port, datagram, rights);
  }

  soccer::GameRequest request;
  if (const auto error = soccer::parse(datagram, request)) return *error;
  if (const auto* init = std::get_if<soccer::MonitorInit>(&request)) {
    return admit_monitor(*init, rights);
  }
  if (port == ListeningPort::kMonitors) return ErrorCode::kUnknownCommand;

  if (const auto* init = std::get_if<soccer::PlayerInit>(&request)) {
    return PlayerRegistry::admit(world_, *init, rights);
  }
  return PlayerRegistry::admit(world_, std::get<soccer::PlayerReconnect>(request), rights);
}

AdmissionResult MatchServer::admit_monitor(const soccer::MonitorInit& init,
                                           const ClientRights& rights) {
  if (!rights.monitor) return Intrusion{ErrorCode::kNoMoreMonitor};
  const int version = monitor_version(init.version);
  if (version == 0) return ErrorCode::kIllegalClientVersion;

  const auto id = monitors_.admit(world_.params().max_monitors);
  if (!id) return ErrorCode::kNoMoreMonitor;
  return Admission{*id, version, false,
                   gamelog::is_binary(static_cast<gamelog::MonitorVersion>(version))};
}

void MatchServer::complete_handshake(const Admission& admission,
                                     std::unique_ptr<soccer::Channel> channel,
                                     std::string_view request) {
  if (is_monitor(admission.client)) {
    monitors_.connect(admission.client, admission.version, std::move(channel), *world_.rules);
    return;
  }

  recorder_.command(world_, admission.client, request);
  if (!is_player(admission.client)) return connect_coach(admission, std::move(channel));

  PlayerSession& session = players_.connect(world_, admission, std::move(channel));
  if (!admission.reconnected && admission.version >= kFirstSynchronousVersion) {
    execute(session, soccer::SynchSee{});
  }
}

void MatchServer::connect_coach(const Admission& admission,
                                std::unique_ptr<soccer::Channel> channel) {
  CoachSession& coach = coaches_.connect(world_, admission, std::move(channel));
  if (coach.is_trainer()) return;

  for (Slot slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    if (players_.session(slot) == nullptr) continue;
    const soccer::Clang& versions = players_.clang_versions(slot);
    if (versions.min_version != 0 || versions.max_version != 0) send_clang_versions(coach, slot);
  }

  send_coach_file(world_, coach);
}

void MatchServer::cancel(const Admission& admission) {
  if (is_player(admission.client)) leave(world_, admission.client);
}

Connection* MatchServer::connection(ClientId client) {
  if (is_player(client)) return session(client);
  return is_monitor(client) ? monitors_.connection(client) : coaches_.session(client);
}

void MatchServer::mark_lost(ClientId id) {
  if (Connection* client = connection(id)) client->lost = true;
}

void MatchServer::disconnect_all() {
  players_.disconnect_all();
  coaches_.disconnect_all();
  monitors_.disconnect_all();
}

void MatchServer::remove_lost() {
  players_.remove_lost(world_);
  coaches_.remove_lost();
  monitors_.remove_lost();
}

void MatchServer::modify_world(const std::function<void(World&, Events&)>& change) {
  change(world_, events_);
  dispatch_events();
}

template <typename Session>
void MatchServer::answer_on_receipt(Session& session) {
  auto* datagram = session.inbox.answerable();
  if (datagram == nullptr) return;
  answer(session, *datagram);
  datagram->answered = true;
}

void MatchServer::receive(ClientId id, std::string_view datagram, bool null_terminated) {
  Connection* client = connection(id);
  if (client == nullptr) return;

  if (!client->quota.consume(datagram.size())) {
    // A client that floods the server must not delay the others by its missing (done).
    if (datagram.find("(done)") != std::string_view::npos) client->done = true;
  } else if (is_monitor(id)) {
    const std::string reply = monitors_.execute(world_, id, datagram, null_terminated, events_);
    dispatch_events();
    if (!reply.empty()) monitors_.send(id, world_.clock, reply);
  } else if (is_player(id)) {
    if (session(id)->inbox.add(datagram, null_terminated)) client->done = true;
    if (answers_on_receipt_) answer_on_receipt(*session(id));
  } else {
    CoachSession& coach = *coaches_.session(id);
    if (coach.inbox.add(datagram, null_terminated, coach.role())) coach.done = true;
    if (answers_on_receipt_) answer_on_receipt(coach);
  }
}

void MatchServer::receive_on_listening_port(ClientId id, std::string_view datagram,
                                            bool null_terminated) {
  Connection* client = connection(id);
  if (client == nullptr) return;

  if (may_use_listening_port(*client)) return receive(id, datagram, null_terminated);
  if (!client->quota.consume(datagram.size())) return;

  std::string error;
  soccer::format(ErrorCode::kOnlyInitAllowedOnInitPort, error);
  if (is_monitor(id)) {
    monitors_.send(id, world_.clock, error);
  } else {
    client->send(error);
  }
}

void MatchServer::execute() {
  execute_players();
  execute_coaches();
}

void MatchServer::execute_players() {
  std::array<Slot, soccer::kPlayersOnPitch> order;
  std::iota(order.begin(), order.end(), 0);
  clock_stream(world_, "command order", 0).shuffle(std::span<Slot>(order));
  for (const Slot slot : order) {
    if (PlayerSession* player = session(slot)) execute(*player);
  }

  remove_lost();
}

void MatchServer::execute_coaches() {
  std::array<ClientId, 2> order = {kLeftCoach, kRightCoach};
  clock_stream(world_, "coach order", 0).shuffle(std::span<ClientId>(order));
  for (const ClientId client : {order[0], order[1], kTrainer}) {
    if (CoachSession* coach = coaches_.session(client)) execute(*coach);
  }

  remove_lost();
}

void MatchServer::execute(PlayerSession& session) {
  for (std::size_t i = 0; i < session.inbox.size() && !session.lost; ++i) {
    const PlayerInbox::Datagram& datagram = session.inbox[i];
    recorder_.command(world_, session.client, datagram.text);
    if (!datagram.answered) answer(session, datagram);
  }

  session.inbox.clear();
}

void MatchServer::answer(PlayerSession& session, const PlayerInbox::Datagram& datagram) {
  if (!datagram.null_terminated) session.reply(soccer::WarningCode::kMessageNotNullTerminated);
  for (std::size_t k = datagram.first; k < datagram.last && !session.lost; ++k) {
    execute(session, session.inbox.commands()[k]);
  }
  if (!datagram.complete) session.reply(ErrorCode::kIllegalCommandForm);
}

void MatchServer::execute(PlayerSession& session, const soccer::PlayerCommand& command) {
  if (std::holds_alternative<soccer::Bye>(command)) {
    leave(world_, session.slot());
    session.lost = true;
  } else if (std::holds_alternative<soccer::RequestSenseBody>(command)) {
    players_.send_sense_body(world_, session);
  } else if (const auto* clang = std::get_if<soccer::Clang>(&command)) {
    declare_clang_versions(session, *clang);
  } else if (const auto* compression = std::get_if<soccer::Compression>(&command)) {
    if (compression->level <= Connection::kMaxCompressionLevel) {
      session.compress(compression->level);
    }
  } else {
    const auto reply =
        session.own_name.empty()
            ? apply(world_, session.slot(), command, events_)
            : apply(world_, session.slot(), with_sides(world_, session, command), events_);
    if (reply) session.reply(*reply);
  }

  dispatch_events();
}

void MatchServer::execute(CoachSession& coach) {
  for (const CoachInbox::Datagram& datagram : coach.inbox.datagrams()) {
    if (coach.lost) break;

    recorder_.command(world_, coach.client, datagram.text);
    if (!datagram.answered) answer(coach, datagram);
  }

  coach.inbox.clear();
}

void MatchServer::answer(CoachSession& coach, const CoachInbox::Datagram& datagram) {
  if (!datagram.null_terminated) coach.reply(soccer::WarningCode::kMessageNotNullTerminated);

  const CoachCommandResult result = coaches_.execute(world_, coach, datagram, events_);
  dispatch_events();

  if (result.message) send_coach_message(*result.message);
  if (result.tile) {
    recorder_.tile(world_, *result.tile);
    monitors_.add_tile(*result.tile);
  }
  if (result.reply) coach.reply(*result.reply);
}

void MatchServer::declare_clang_versions(PlayerSession& session, const soccer::Clang& versions) {
  const Slot slot = session.slot();
  players_.clang_versions(slot) = versions;
  session.reply(soccer::OkClang{versions.min_version, versions.max_version});

  const ClientId coach = soccer::side_of_slot(slot) == Side::kLeft ? kLeftCoach : kRightCoach;
  if (coaches_.session(coach) != nullptr) send_clang_versions(*coaches_.session(coach), slot);
}

void MatchServer::step() {
  see(world_.params().simulator_step - 1);
  players_.begin_step();
  monitors_.begin_step();

  coach_messages_.clear();
  coaches_.begin_step(world_, coach_messages_);
  for (const CoachMessage& message : coach_messages_) send_coach_message(message);

  simulator::step(world_, events_);
  dispatch_events();

  coaches_.end_step(world_);
  recorder_.step(world_);
  monitors_.send_frame(world_);

  finish_step(world_, events_);
  dispatch_events();
  players_.end_step();
}

void MatchServer::sense() {
  players_.send_senses(world_);
  see(0);
  coaches_.send_views(world_);
}

void MatchServer::see(int ms) { players_.send_due_sees(world_, ms); }

void MatchServer::think() {
  think_players();
  think_coaches();
}

void MatchServer::think_players() {
  see(world_.params().synch_offset);
  players_.send_think(world_);
}

void MatchServer::think_coaches() { coaches_.send_think(); }

bool MatchServer::coaches_are_late() const {
  return clock_stream(world_, "late coaches", 0).bernoulli(kLateCoachesShare);
}

bool MatchServer::awaits(ClientId client) const {
  if (!is_player(client)) {
    const CoachSession* coach = coaches_.session(client);
    return coach != nullptr && coach->is_awaited();
  }

  const PlayerSession* player = players_.session(client);
  return player != nullptr && player->is_awaited() && world_.player(client).enabled;
}

bool MatchServer::awaits_any_client() const {
  for (ClientId client = 0; client < kFirstMonitor; ++client) {
    if (awaits(client)) return true;
  }
  return false;
}

bool MatchServer::awaits_coaches() const {
  return awaits(kLeftCoach) || awaits(kRightCoach) || awaits(kTrainer);
}

bool MatchServer::finished() const {
  if (world_.mode == PlayMode::kTimeOver) return true;
  const int lead = world_.team(Side::kLeft).score - world_.team(Side::kRight).score;
  if (decisive_lead_ && std::abs(lead) >= *decisive_lead_) return true;
  return cycle_limit_ && world_.clock.time >= *cycle_limit_;
}

}  // namespace cls::simulator
