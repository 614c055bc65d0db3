// The forms of hear for players, online coaches and trainers.
#include "soccer/messages/hear.h"

#include <cassert>

#include "soccer/messages/sense_groups.h"
#include "soccer/protocol/observation_name.h"
#include "soccer/protocol/scanner.h"
#include "soccer/side.h"

namespace cls::soccer {
namespace {

using Sender = Hear::Sender;

// The rest of the message as text, with or without quotes.
bool read_text(Scanner& in, bool quoted, std::string& out) {
  std::string_view text;

  if (quoted && !in.literal("\"")) return false;
  if (!in.rest_before(quoted ? "\")" : ")", text)) return false;
  if (text.empty()) return in.fail("a text");

  out.assign(text);
  return true;
}

// After "(hear T referee ": quotes mean a message of the trainer to itself.
bool read_referee_or_trainer(Scanner& in, Hear& out) {
  const bool quoted = in.peek() == '"';
  out.sender = quoted ? Sender::kTrainer : Sender::kReferee;
  return read_text(in, quoted, out.text);
}

bool read_speaker(Scanner& in, Hear& out) {
  out.sender = Sender::kPlayer;
  return read_player(in, out.team, out.unum, out.goalie) && in.literal(") ") &&
         read_text(in, true, out.text);
}

// "our UNUM" or "opp", then a text unless partial.
bool read_side_and_text(Scanner& in, Hear& out) {
  if (in.optional("our ")) {
    out.sender = Sender::kTeammate;
    if (!in.integer(out.unum, 1, kPlayersPerTeam)) return false;
  } else if (in.optional("opp")) {
    out.sender = Sender::kOpponent;
  } else {
    return in.fail("our or opp");
  }

  if (out.partial) return in.literal(")");
  return in.literal(" ") && read_text(in, true, out.text);
}

bool read_sender(Scanner& in, Hear& out) {
  if (in.optional("referee ")) return read_referee_or_trainer(in, out);
  if (in.optional("(p ")) return read_speaker(in, out);

  const bool trainer = in.optional("coach ");
  if (trainer || in.optional("self ")) {
    out.sender = trainer ? Sender::kTrainer : Sender::kSelf;
    return read_text(in, true, out.text);
  }

  const bool left = in.optional("online_coach_left ");
  if (left || in.optional("online_coach_right ")) {
    out.sender = left ? Sender::kOnlineCoachLeft : Sender::kOnlineCoachRight;
    return read_text(in, in.peek() == '"', out.text);
  }

  out.partial = in.peek() == 'o';
  return (out.partial || in.sequence(out.direction, " ")) && read_side_and_text(in, out);
}

bool read_message(Scanner& in, Hear& out) {
  if (!in.literal("(hear ")) return false;

  if (in.optional("referee ")) {  // to a trainer, name before time
    out.sender = Sender::kReferee;
    return in.sequence(out.time, " ") && read_text(in, false, out.text);
  }

  return in.sequence(out.time, " ") && read_sender(in, out);
}

void append_text(std::string_view before, const Hear& hear, bool quoted, std::string& out) {
  const std::string_view quote = quoted ? "\"" : "";
  append(out, before, quote, hear.text, quote);
}

void append_player_message(const Hear& hear, std::string& out) {
  if (!hear.partial) append(out, hear.direction, ' ');
  if (hear.sender == Sender::kTeammate) {
    append(out, "our ", hear.unum);
  } else {
    out.append("opp");
  }

  if (!hear.partial) append_text(" ", hear, true, out);
}

}  // namespace

base::Result<void> parse(std::string_view message, Hear& out) {
  out.partial = out.goalie = false;
  out.direction = out.unum = 0;
  out.team = TeamName();
  out.text.clear();

  Scanner in(message);
  return in.finish(read_message(in, out), "hear");
}

void format(const Hear& hear, Recipient recipient, std::string& out) {
  const bool to_trainer = recipient == Recipient::kTrainer;
  if (hear.sender == Sender::kReferee && to_trainer) {
    append(out, "(hear referee ", hear.time, ' ', hear.text, ')');
    return;
  }

  append(out, "(hear ", hear.time, ' ');
  switch (hear.sender) {
    case Sender::kReferee:
      append_text("referee ", hear, false, out);
      break;
    case Sender::kTrainer:
      append_text(recipient == Recipient::kPlayer ? "coach " : "referee ", hear,
                  recipient != Recipient::kOnlineCoach, out);
      break;
    case Sender::kOnlineCoachLeft:
      append_text("online_coach_left ", hear, to_trainer, out);
      break;
    case Sender::kOnlineCoachRight:
      append_text("online_coach_right ", hear, to_trainer, out);
      break;
    case Sender::kSelf:
      append_text("self ", hear, true, out);
      break;
    case Sender::kTeammate:
    case Sender::kOpponent:
      append_player_message(hear, out);
      break;
    case Sender::kPlayer:
      out.append("(p ");
      append_player(hear.team, hear.unum, hear.goalie, out);
      append_text(") ", hear, true, out);
      break;
  }

  out.push_back(')');
}

}  // namespace cls::soccer
