// Responses of players to the server per cycle, from the text log.
#pragma once

#include <array>

#include "analysis/play/flow.h"
#include "gamelog/rcl/logged_commands.h"
#include "gamelog/rcl/rcl_record.h"

namespace cls::analysis {

/// Counts of one player. A step leads from one frame to the next and includes commands received at
/// the clock of the first. Only steps between frames at which the player is connected count, until
/// the end of the match.
struct Responsiveness {
  int steps = 0;
  int answered = 0;         ///< steps with at least one datagram
  int silent = 0;           ///< steps without a datagram; in synch mode without (done)
  int no_body_command = 0;  ///< although the player could act and the play mode allows it
  int several_body = 0;    ///< steps with more than one body command: the server executes the first
  int late_steps = 0;      ///< several body commands next to a step without any
  int rejected_kicks = 0;  ///< sent but not executed
  int rejected_tackles = 0;
  int rejected_turn_necks = 0;
  int intentional_fouls = 0;  ///< (tackle ANGLE true)
  int say_characters = 0;
  int datagrams = 0;
  std::array<int, gamelog::kCommandKindCount> commands = {};  ///< sent, by CommandKind

  int rejected() const { return rejected_kicks + rejected_tackles + rejected_turn_necks; }
  double silent_share() const { return steps == 0 ? 0.0 : static_cast<double>(silent) / steps; }
};

/// `text` must be the text log of the same match; players without lines count as silent.
PerPlayer<Responsiveness> measure_responsiveness(const Flow& flow, const gamelog::RclRecord& text);

/// View and attention from the game log alone, in frames at which the player is connected.
struct Attention {
  int frames = 0;
  int narrow = 0;  ///< view width below 90 degrees
  int normal = 0;  ///< below 150
  int wide = 0;
  int low_quality = 0;
  double mean_view_width = 0.0;
  int attentive = 0;            ///< frames with an attention target
  PerPlayer<int> targets = {};  ///< frames by target
  int pointing = 0;
  gamelog::Counters counted = {};  ///< executed commands, by Counter
};

PerPlayer<Attention> measure_attention(const gamelog::MatchRecord& record);

/// Team of each name in the text log: 0 left, 1 right, -1 neither. By the names in the game log,
/// otherwise (equal or missing names) by order of appearance.
std::array<std::int8_t, 256> assign_sides(const gamelog::MatchRecord& record,
                                          const gamelog::RclRecord& text);

}  // namespace cls::analysis
