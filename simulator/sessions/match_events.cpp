// Sends the events of the match to players, coaches, monitors and logs.
#include <variant>

#include "base/overloaded.h"
#include "simulator/sessions/match_server.h"
#include "simulator/world/roster.h"

namespace cls::simulator {

void MatchServer::dispatch_events() {
  for (const Event& event : events_) dispatch(event);
  events_.clear();
}

void MatchServer::dispatch(const Event& event) {
  std::visit(
      base::Overloaded{
          [&](const RefereeMessage& message) { send_referee_message(event.clock, message); },
          [&](const PlayerSaid& said) { send_say(event.clock, said); },
          [&](const TypeChanged& change) { send_type_change(event.clock, change); },
          [&](const GoalieAppointed& change) { send_goalie_change(event.clock, change); },
          [&](const SentOff& sent_off) { mark_lost(sent_off.slot); }, [](const ModeChanged&) {}},
      event.what);
}

void MatchServer::announce_end() {
  referee_message_.time = world_.clock.time;
  referee_message_.text = name(PlayMode::kTimeOver);
  players_.send_referee_message(world_, referee_message_);
  coaches_.send_referee_message(referee_message_);
}

void MatchServer::send_referee_message(Clock clock, const RefereeMessage& message) {
  soccer::Hear& hear = referee_message_;
  hear.time = clock.time;
  hear.text.clear();
  message.append_to(hear.text);
  recorder_.referee(clock, hear.text);
  if (monitors_hear()) monitors_.send_to_all(clock, "(referee " + hear.text + ')');
  players_.send_referee_message(world_, hear);
  coaches_.send_referee_message(hear);
}

void MatchServer::send_say(Clock clock, const PlayerSaid& said) {
  if (monitors_hear() || recorder_.records_messages()) {
    const Player& player = world_.player(said.speaker);
    std::string speaker = "(player ";
    speaker += world_.team(player.side).name.view();
    speaker += ' ' + std::to_string(player.unum) + ')';
    record_message(clock, speaker, said.text);
  }
  players_.queue_say(world_, said);
  coaches_.send_say(world_, said);
}

void MatchServer::send_coach_message(const CoachMessage& message) {
  players_.send_coach_message(world_, message);
  coaches_.send_coach_message(world_, message);
  const std::string& text = message.say.text;
  if (message.side == Side::kNeutral) return record_message(world_.clock, "referee", text);
  record_message(world_.clock,
                 message.side == Side::kLeft ? "online_coach_left" : "online_coach_right",
                 std::to_string(message.received) + ' ' + text);
}

void MatchServer::send_type_change(Clock clock, const TypeChanged& change) {
  record_substitution(clock, change.side, change.unum, std::to_string(change.type));
  players_.send_type_change(change);
  coaches_.send_type_change(change);
}

void MatchServer::send_goalie_change(Clock clock, const GoalieAppointed& change) {
  record_substitution(clock, change.side, change.unum, "goalie");
  players_.send_goalie_change(change);
  coaches_.send_goalie_change(change);
}

void MatchServer::send_clang_versions(CoachSession& coach, Slot slot) {
  const Player& player = world_.player(slot);
  const soccer::Clang& versions = players_.clang_versions(slot);
  coach.reply(soccer::ClangSupport{visible_team_name(world_, player.side, player.side), player.unum,
                                   player.goalie, versions.min_version, versions.max_version});
}

// Sends a substitution to monitors and the game log; `what` is the player type or "goalie".
void MatchServer::record_substitution(Clock clock, Side side, int unum, const std::string& what) {
  const std::string text = "(change_player_type " + std::string(1, letter(side)) + ' ' +
                           std::to_string(unum) + ' ' + what + ')';
  monitors_.send_to_all(clock, text);
  recorder_.substitution(world_, clock, text);
}

bool MatchServer::monitors_hear() const {
  return world_.params().send_comms && monitors_.connected() > 0;
}

// Sends a message to monitors and the game log.
void MatchServer::record_message(Clock clock, std::string_view speaker, std::string_view text) {
  if (!monitors_hear() && !recorder_.records_messages()) return;
  std::string message = "(";
  message += speaker;
  message += ' ';
  message += text;
  message += ')';
  if (monitors_hear()) monitors_.send_to_all(clock, message);
  recorder_.message(world_, clock, message);
}

}  // namespace cls::simulator
