// How well players answered the server, cycle by cycle: needs the text log.
#pragma once

#include <array>
#include <cstddef>

#include "analysis/play/flow.h"
#include "gamelog/rcl/logged_commands.h"
#include "gamelog/rcl/rcl_record.h"

namespace cls::analysis {

/// One player. A step leads from one frame to the next; what was received at the clock of the first
/// counts for it. Steps between frames at which he is connected, before the end of the match.
struct Responsiveness {
  int steps = 0;
  int answered = 0;         ///< steps with a datagram at least
  int silent = 0;           ///< steps without one; in synchronous mode: without (done)
  int no_body_command = 0;  ///< although he could act and the mode let him
  int several_body = 0;     ///< steps with more than one body command: only the first counts
  int slips = 0;            ///< several body commands next to a step without any: late, not lazy
  int rejected_kicks = 0;   ///< asked for more often than carried out
  int rejected_tackles = 0;
  int rejected_turn_necks = 0;
  int intentional_fouls = 0;  ///< (tackle ANGLE true)
  int say_characters = 0;
  int datagrams = 0;
  std::array<int, gamelog::kCommandKindCount> commands = {};  ///< asked for, by CommandKind

  double silent_share() const { return steps == 0 ? 0.0 : static_cast<double>(silent) / steps; }
};

/// `text` must be the text log of the same match; without its lines everyone is silent.
PerPlayer<Responsiveness> responsiveness_of(const Flow& flow, const gamelog::RclRecord& text);

/// What the game log alone tells of how players look and speak: shares of frames at which they are
/// connected.
struct Attention {
  int frames = 0;
  int narrow = 0;  ///< view width below 90 degrees
  int normal = 0;  ///< below 150
  int wide = 0;
  int low_quality = 0;
  double mean_view_width = 0.0;
  int attentive = 0;            ///< frames with a player he listens to
  PerPlayer<int> targets = {};  ///< frames by whom
  int pointing = 0;
  gamelog::Counters counted = {};  ///< accepted commands, by Counter
};

PerPlayer<Attention> attention_of(const gamelog::MatchRecord& record);

/// Left or right for each name of the text log: 0 left, 1 right, -1 neither. By the names of the
/// game log; where both teams have the same or none, by order of appearance.
std::array<std::int8_t, 256> sides_of_names(const gamelog::MatchRecord& record,
                                            const gamelog::RclRecord& text);

}  // namespace cls::analysis
