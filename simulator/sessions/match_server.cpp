// A cycle of the server: commands, step, senses, think.
#include "simulator/sessions/match_server.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

#include "simulator/actions/actions.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/full_view.h"
#include "simulator/step.h"
#include "simulator/world/roster.h"
#include "soccer/messages/sense_body.h"

namespace cls::simulator {
namespace {

// Room for what a cycle may need, from the beginning: a cycle does not allocate.
constexpr std::size_t kLongMessage = 8192;  // bytes
constexpr std::size_t kLongWord = 64;       // of the referee
constexpr std::size_t kManyEvents = 64;

/// Rounds after which a see is due (simulation model 7.2).
int view_interval(const View& view) {
  const int width = static_cast<int>(view.width);
  if (view.synchronous) return width + 1;
  const int rounds = 2 << width;
  return view.quality == soccer::ViewQuality::kHigh ? rounds : rounds / 2;
}

/// On rcssserver coaches are asked last and answer fast: in 60 matches of helios-base they knew of
/// 8 of 147 fouls in the cycle of the foul, and made 3.0 of 6 substitutions that need a word of the
/// same cycle. With this share they make as many here.
constexpr double kLateCoaches = 1.0 / 16.0;

}  // namespace

base::Result<std::unique_ptr<MatchServer>> MatchServer::create(const MatchConfig& config) {
  auto rules = make_rules(config.server, config.player, config.seed);
  if (!rules) return rules.error();
  return std::unique_ptr<MatchServer>(new MatchServer(std::move(*rules), config));
}

MatchServer::MatchServer(std::shared_ptr<const Rules> rules, const MatchConfig& config)
    : world_(make_world(rules, config.seed)),
      vision_(rules->server),
      coaches_(rules->server),
      cycle_limit_(config.cycle_limit) {
  see_.objects.reserve(soccer::kMaxObservations);
  text_.reserve(kLongMessage);
  referee_.text.reserve(kLongWord);
  events_.reserve(kManyEvents);
  heard_.reserve(soccer::kPlayersOnPitch);
}

void MatchServer::record(const LogSinks& sinks) { recorder_.begin(sinks, *world_.rules); }

Connection* MatchServer::connection(ClientId client) {
  if (is_player(client)) return session(client);
  return is_monitor(client) ? monitors_.connection(client) : coaches_.session(client);
}

void MatchServer::arrange(const std::function<void(World&, Events&)>& change) {
  change(world_, events_);
  dispatch_events();
}

void MatchServer::receive(ClientId id, std::string_view datagram, bool null_terminated) {
  Connection* client = connection(id);
  if (client == nullptr) return;
  if (!client->allowance.take(datagram.size())) {
    // Whoever floods us must not make the others wait for its (done) as well.
    if (datagram.find("(done)") != std::string_view::npos) client->done = true;
  } else if (is_monitor(id)) {
    obey_monitor(id, datagram, null_terminated);
  } else if (is_player(id)) {
    if (session(id)->inbox.add(datagram, null_terminated)) client->done = true;
  } else {
    CoachSession& coach = *coaches_.session(id);
    if (coach.inbox.add(datagram, null_terminated, coach.role())) coach.done = true;
  }
}

void MatchServer::lose(ClientId id) {
  if (Connection* client = connection(id)) client->lost = true;
}

void MatchServer::disconnect_all() {
  for (auto& client : sessions_) client.reset();
  coaches_.disconnect_all();
  monitors_.disconnect_all();
}

int MatchServer::connected() const {
  return static_cast<int>(std::count_if(sessions_.begin(), sessions_.end(),
                                        [](const auto& client) { return client != nullptr; }));
}

void MatchServer::execute() {
  execute_players();
  execute_coaches();
}

void MatchServer::execute_players() {
  std::array<Slot, soccer::kPlayersOnPitch> order;
  std::iota(order.begin(), order.end(), 0);
  stream("command order", 0).shuffle(std::span<Slot>(order));
  for (const Slot slot : order) {
    if (Session* client = session(slot)) execute(*client);
  }
  remove_lost();
}

void MatchServer::execute_coaches() {
  std::array<ClientId, 2> coach_order = {kLeftCoach, kRightCoach};
  stream("coach order", 0).shuffle(std::span<ClientId>(coach_order));
  for (const ClientId client : {coach_order[0], coach_order[1], kTrainer}) {
    if (CoachSession* coach = coaches_.session(client)) execute(*coach);
  }
  remove_lost();
}

void MatchServer::execute(Session& client) {
  for (std::size_t i = 0; i < client.inbox.size() && !client.lost; ++i) {
    const Inbox::Datagram& datagram = client.inbox[i];
    recorder_.command(world_, client.client, datagram.text);
    if (!datagram.null_terminated) client.reply(soccer::WarningCode::kMessageNotNullTerminated);
    for (std::size_t k = datagram.first; k < datagram.last && !client.lost; ++k) {
      execute(client, client.inbox.commands()[k]);
    }
    if (!datagram.complete) client.reply(soccer::ErrorCode::kIllegalCommandForm);
  }
  client.inbox.clear();
}

void MatchServer::execute(Session& client, const soccer::PlayerCommand& command) {
  if (std::holds_alternative<soccer::Bye>(command)) {
    leave(world_, client.slot());
    client.lost = true;
  } else if (std::holds_alternative<soccer::AskSenseBody>(command)) {
    send_sense_body(client);
  } else if (const auto* clang = std::get_if<soccer::Clang>(&command)) {
    declare(client, *clang);
  } else if (const auto* compression = std::get_if<soccer::Compression>(&command)) {
    if (compression->level <= Connection::kMostCompression) client.compress(compression->level);
  } else if (auto answer = apply(world_, client.slot(), command, events_)) {
    client.reply(*answer);
  }
  dispatch_events();
}

void MatchServer::execute(CoachSession& coach) {
  for (const CoachInbox::Datagram& datagram : coach.inbox.datagrams()) {
    if (coach.lost) break;
    recorder_.command(world_, coach.client, datagram.text);
    if (!datagram.null_terminated) coach.reply(soccer::WarningCode::kMessageNotNullTerminated);
    const CoachOutcome outcome = coaches_.execute(world_, coach, datagram, events_);
    dispatch_events();
    if (outcome.words) tell_words(*outcome.words);
    if (outcome.tile) {
      recorder_.tile(world_, *outcome.tile);
      monitors_.add(*outcome.tile);
    }
    if (outcome.reply) coach.reply(*outcome.reply);
  }
  coach.inbox.clear();
}

void MatchServer::remove_lost() {
  for (auto& client : sessions_) {
    if (client == nullptr || !client->lost) continue;
    Player& player = world_.player(client->slot());
    if (player.enabled) leave(world_, player.slot());
    player.state &= ~state::kDiscard;  // shown until the connection is closed
    client.reset();
  }
  coaches_.remove_lost();
  monitors_.remove_lost();
}

void MatchServer::step() {
  see(world_.params().simulator_step - 1);
  for (auto& client : sessions_) {
    if (client != nullptr) client->begin_step();
  }
  monitors_.begin_step();
  coach_words_.clear();
  coaches_.begin_step(world_, coach_words_);
  for (const CoachWords& words : coach_words_) tell_words(words);
  simulator::step(world_, events_);
  dispatch_events();
  coaches_.end_step(world_);
  recorder_.step(world_);
  monitors_.show(world_);
  finish_step(world_, events_);
  dispatch_events();
  ++steps_;
  saw_ = false;
}

void MatchServer::sense() {
  for (auto& client : sessions_) {
    if (client == nullptr || !world_.player(client->slot()).enabled) continue;
    Player& player = world_.player(client->slot());
    send_sense_body(*client);
    player.contacts = {};
    if (has_full_state(world_, player)) send_full_state(*client);
    send_hearing(*client);
  }
  see(0);
  coaches_.send_views(world_);
}

void MatchServer::see(int ms) {
  asynchronous_rounds(ms);
  if (saw_ || ms < world_.params().synch_see_offset) return;
  view_round(true);
  saw_ = true;
}

void MatchServer::think() {
  think_players();
  think_coaches();
}

void MatchServer::think_players() {
  see(world_.params().synch_offset);
  text_.clear();
  soccer::format(soccer::ServerReply(soccer::Think{}), text_);
  for (auto& client : sessions_) {
    if (client == nullptr || !world_.player(client->slot()).enabled) continue;
    client->send(text_);
    client->asked = true;
  }
}

void MatchServer::think_coaches() {
  text_.clear();
  soccer::format(soccer::ServerReply(soccer::Think{}), text_);
  coaches_.ask(text_);
}

bool MatchServer::coaches_are_late() const {
  return stream("late coaches", 0).bernoulli(kLateCoaches);
}

bool MatchServer::awaits(ClientId client) const {
  if (!is_player(client)) {
    const CoachSession* coach = coaches_.session(client);
    return coach != nullptr && coach->is_awaited();
  }
  const auto& player = sessions_[static_cast<std::size_t>(client)];
  return player != nullptr && player->is_awaited() && world_.player(client).enabled;
}

bool MatchServer::awaits_anybody() const {
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
  return cycle_limit_ && world_.clock.time >= *cycle_limit_;
}

void MatchServer::finish() { recorder_.finish(world_); }

void MatchServer::view_round(bool synchronous) {
  for (auto& client : sessions_) {
    if (client == nullptr) continue;
    const Player& player = world_.player(client->slot());
    if (!player.enabled || player.view.synchronous != synchronous) continue;
    if (++client->view_rounds < view_interval(player.view)) continue;
    client->view_rounds = 0;
    send_see(*client);
  }
}

void MatchServer::asynchronous_rounds(int until_ms) {
  // In virtual time; a round falls due every quarter of send_step, not always a whole millisecond.
  const std::int64_t now = steps_ * world_.params().simulator_step + until_ms;
  const std::int64_t due = now * 4 / world_.params().send_step;
  for (; asynchronous_rounds_ < due; ++asynchronous_rounds_) view_round(false);
}

RandomStream MatchServer::stream(std::string_view purpose, Slot slot) const {
  const auto time = static_cast<std::uint64_t>(world_.clock.time);
  const auto stoppage = static_cast<std::uint64_t>(world_.clock.stoppage);
  return RandomStream(world_.seed, purpose, static_cast<std::uint64_t>(slot),
                      (time << 32) | stoppage);
}

}  // namespace cls::simulator
