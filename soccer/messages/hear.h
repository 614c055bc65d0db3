// The hear message: messages of referee, coaches, trainer and players.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "soccer/protocol/team_name.h"

namespace cls::soccer {

/// The recipient of a message; the forms differ (docs/spec/server-protocol.md 4.4 and 5.5).
enum class Recipient : std::uint8_t { kPlayer, kOnlineCoach, kTrainer };

struct Hear {
  enum class Sender : std::uint8_t {
    kReferee,           ///< text: a play mode or another referee message
    kTrainer,           ///< text: plain; an online coach receives it as kReferee
    kOnlineCoachLeft,   ///< text: coach language, with parentheses
    kOnlineCoachRight,  ///< likewise
    kSelf,              ///< the own say message of a player
    kTeammate,          ///< to a player
    kOpponent,          ///< to a player
    kPlayer,            ///< to a coach or trainer: team, unum and goalie name the player
  };

  int time = 0;
  Sender sender = Sender::kReferee;
  bool partial = false;  ///< kTeammate, kOpponent: the text is missing
  bool goalie = false;   ///< kPlayer
  int direction = 0;     ///< kTeammate, kOpponent with text: degrees relative to the own body
  int unum = 0;          ///< kTeammate, kPlayer
  TeamName team{};       ///< kPlayer
  std::string text{};    ///< without quotes; empty when partial
};

/// Parses a hear message to any recipient (version 8 and later). Errors name the byte and leave
/// `out` unspecified. Does not allocate once `out.text` has enough capacity.
base::Result<void> parse(std::string_view message, Hear& out);

/// Appends the message in the form for `recipient`, who must be able to receive from this sender.
void format(const Hear& hear, Recipient recipient, std::string& out);

}  // namespace cls::soccer
