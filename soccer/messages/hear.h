// The hear message: what referee, coaches, trainer and players say.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "soccer/protocol/team_name.h"

namespace cls::soccer {

/// Who receives a message; the forms differ (protocol 4.4 and 5.5).
enum class Listener : std::uint8_t { kPlayer, kOnlineCoach, kTrainer };

struct Hear {
  enum class Sender : std::uint8_t {
    kReferee,           ///< text: a play mode or another referee message
    kTrainer,           ///< text: what the trainer says; an online coach hears it as kReferee
    kOnlineCoachLeft,   ///< text: coach language, with its brackets
    kOnlineCoachRight,  ///< the same
    kSelf,              ///< a player's own words come back
    kTeammate,          ///< to a player
    kOpponent,          ///< to a player
    kPlayer,            ///< to a coach or trainer: team, unum and goalie name the player
  };

  int time = 0;
  Sender sender = Sender::kReferee;
  bool partial = false;  ///< kTeammate, kOpponent: only that something was said
  bool goalie = false;   ///< kPlayer
  int direction = 0;     ///< kTeammate, kOpponent in full: degrees relative to the own body
  int unum = 0;          ///< kTeammate, kPlayer
  TeamName team;         ///< kPlayer
  std::string text;      ///< without quotes; empty when partial
};

/// Reads a hear message of any listener (version 8 and later). On failure the message names the
/// byte and `out` is unspecified. Does not allocate once `out.text` has grown.
base::Result<void> parse(std::string_view message, Hear& out);

/// Appends the message in the form of that listener. Sender and listener must fit together.
void format(const Hear& hear, Listener listener, std::string& out);

}  // namespace cls::soccer
