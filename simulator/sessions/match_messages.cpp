// What the match server sends: senses, the referee's words, changes of type, replies.
#include <variant>

#include "base/overloaded.h"
#include "simulator/actions/actions.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/full_view.h"
#include "simulator/sessions/match_server.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/sense_body.h"

namespace cls::simulator {
namespace {

constexpr int kFirstGoalieChangeVersion = 16;

/// Heard by players that have not said that they understand it.
constexpr const char* kUnsupported = "(unsupported_clang)";

}  // namespace

// Who is sent off is off the pitch already, but hears of his card before he loses his connection.
void MatchServer::broadcast(std::string_view message) {
  for (auto& client : sessions_) {
    if (client == nullptr || client->lost) continue;
    const Player& player = world_.player(client->slot());
    if (player.enabled || player.has(state::kRedCard)) client->send(message);
  }
}

void MatchServer::dispatch_events() {
  for (const Event& event : events_) dispatch(event);
  events_.clear();
}

void MatchServer::dispatch(const Event& event) {
  std::visit(base::Overloaded{
                 [&](const RefereeSaid& said) { tell_referee(event.clock, said); },
                 [&](const PlayerSaid& said) { tell_said(event.clock, said); },
                 [&](const TypeChanged& change) { tell_type(event.clock, change); },
                 [&](const GoalieAppointed& change) { tell_goalie(event.clock, change); },
                 [&](const SentOff& sent_off) { lose(sent_off.slot); }, [](const ModeChanged&) {}},
             event.what);
}

void MatchServer::tell_referee(Clock clock, const RefereeSaid& said) {
  referee_.time = clock.time;
  referee_.text.clear();
  said.append_to(referee_.text);
  recorder_.referee(clock, referee_.text);
  if (monitors_hear()) monitors_.tell(clock, "(referee " + referee_.text + ')');
  text_.clear();
  soccer::format(referee_, soccer::Listener::kPlayer, text_);
  broadcast(text_);
  coaches_.tell_referee(referee_);
}

void MatchServer::tell_said(Clock clock, const PlayerSaid& said) {
  if (audience_hears()) tell_audience(clock, speaker_name(said.speaker), said.text);
  for (auto& client : sessions_) {
    if (client != nullptr) overhear(world_, said, client->slot(), client->hearing);
  }
  coaches_.tell_said(world_, said);
}

// A coach's words reach its players at once, a trainer's wait for the next sense_body.
void MatchServer::tell_words(const CoachWords& words) {
  for (auto& client : sessions_) {
    if (client == nullptr || !world_.player(client->slot()).enabled) continue;
    if (words.side == Side::kNeutral) {
      client->hearing.of_trainer.push_back(words.said.text);
      continue;
    }
    if (words.side != soccer::side_of_slot(client->slot())) continue;
    soccer::Hear hear;
    hear.time = world_.clock.time;
    hear.sender = words.side == Side::kLeft ? soccer::Hear::Sender::kOnlineCoachLeft
                                            : soccer::Hear::Sender::kOnlineCoachRight;
    const soccer::Clang& versions = clang_versions_[static_cast<std::size_t>(client->slot())];
    hear.text = understands(versions, words.said.kind) ? words.said.text : kUnsupported;
    text_.clear();
    soccer::format(hear, soccer::Listener::kPlayer, text_);
    client->send(text_);
  }
  coaches_.tell_words(world_, words);
  tell_audience(world_.clock, words);
}

void MatchServer::declare(Session& client, const soccer::Clang& versions) {
  clang_versions_[static_cast<std::size_t>(client.slot())] = versions;
  const ClientId coach =
      soccer::side_of_slot(client.slot()) == Side::kLeft ? kLeftCoach : kRightCoach;
  client.reply(soccer::OkClang{versions.min_version, versions.max_version});
  if (coaches_.session(coach) != nullptr) tell_coach(*coaches_.session(coach), client.slot());
}

void MatchServer::tell_coach(CoachSession& coach, Slot slot) {
  const Player& player = world_.player(slot);
  const soccer::Clang& versions = clang_versions_[static_cast<std::size_t>(slot)];
  coach.reply(soccer::ClangSupport{world_.team(player.side).name, player.unum, player.goalie,
                                   versions.min_version, versions.max_version});
}

std::string MatchServer::speaker_name(Slot slot) const {
  const Player& player = world_.player(slot);
  std::string name = "(player ";
  name += world_.team(player.side).name.view();
  name += ' ' + std::to_string(player.unum);
  return name + ')';
}

// Monitors, and whoever reads the game log; `what` the player is now.
void MatchServer::tell_substitution(Clock clock, Side side, int unum, const std::string& what) {
  const std::string words = "(change_player_type " + std::string(1, letter(side)) + ' ' +
                            std::to_string(unum) + ' ' + what + ')';
  monitors_.tell(clock, words);
  recorder_.substitution(world_, clock, words);
}

void MatchServer::tell_type(Clock clock, const TypeChanged& change) {
  tell_substitution(clock, change.side, change.unum, std::to_string(change.type));
  for (auto& client : sessions_) {
    if (client == nullptr) continue;
    soccer::PlayerTypeChange told{change.unum, std::nullopt};
    if (soccer::side_of_slot(client->slot()) == change.side) told.type = change.type;
    client->reply(told);
  }
  coaches_.tell_type(change);
}

void MatchServer::tell_goalie(Clock clock, const GoalieAppointed& change) {
  tell_substitution(clock, change.side, change.unum, "goalie");
  for (auto& client : sessions_) {
    if (client == nullptr || client->version < kFirstGoalieChangeVersion) continue;
    client->reply(soccer::PlayerTypeChange{change.unum, std::nullopt, change.side});
  }
  coaches_.tell_goalie(change);
}

void MatchServer::send_sense_body(Session& client) {
  text_.clear();
  soccer::format(sense_body(world_, client.slot()), client.version, text_);
  client.send(text_);
}

void MatchServer::send_full_state(Session& client) {
  full_state(world_, client.slot(), full_state_);
  text_.clear();
  soccer::format(full_state_, client.version, text_);
  client.send(text_);
}

void MatchServer::send_hearing(Session& client) {
  if (client.hearing.waiting.empty() && client.hearing.of_trainer.empty()) return;
  RandomStream choice = stream("hear", client.slot());
  heard_.clear();
  hear(world_, client.slot(), client.hearing, choice, heard_);
  for (const soccer::Hear& words : heard_) {
    text_.clear();
    soccer::format(words, soccer::Listener::kPlayer, text_);
    client.send(text_);
  }
}

void MatchServer::send_see(Session& client) {
  RandomStream noise = stream("see", client.slot());
  simulator::see(vision_, world_, client.slot(), noise, see_);
  text_.clear();
  soccer::format(see_, text_);
  client.send(text_);
}

}  // namespace cls::simulator
