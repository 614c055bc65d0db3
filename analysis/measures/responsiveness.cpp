// Compares the commands in the text log with the game log, step by step.
#include "analysis/measures/responsiveness.h"

#include <algorithm>
#include <cmath>

namespace cls::analysis {
namespace {

using gamelog::CommandKind;

constexpr std::uint32_t kImmobile =
    gamelog::kStateTackle | gamelog::kStateTackleFailed | gamelog::kStateCharged;

// Commands of one player at one clock.
struct SentCommands {
  int datagrams = 0;
  int body = 0;
  std::array<int, gamelog::kCommandKindCount> commands = {};  ///< by CommandKind

  int count(CommandKind kind) const { return commands[base::index(kind)]; }
};

bool requests_foul(std::string_view arguments) {
  return arguments.ends_with(" true") || arguments.ends_with(" on");
}

void add_datagram(std::string_view datagram, SentCommands& sent, Responsiveness& player) {
  ++sent.datagrams;
  ++player.datagrams;

  gamelog::CommandCursor cursor(datagram);
  gamelog::LoggedCommand command;
  while (cursor.next(command)) {
    ++sent.commands[base::index(command.kind)];
    ++player.commands[base::index(command.kind)];
    sent.body += gamelog::is_body_command(command.kind);

    if (command.kind == CommandKind::kTackle) {
      player.intentional_fouls += requests_foul(command.arguments);
    }
    if (command.kind == CommandKind::kSay) {
      player.say_characters +=
          static_cast<int>(command.arguments.size()) - (command.arguments.starts_with('"') ? 2 : 0);
    }
  }
}

int clock_order(const gamelog::RclLine& line, const gamelog::MatchRecord& record,
                std::size_t frame) {
  if (line.time != record.time[frame]) return line.time < record.time[frame] ? -1 : 1;
  if (line.stopped == record.stopped[frame]) return 0;
  return line.stopped < record.stopped[frame] ? -1 : 1;
}

class LogWalker {
 public:
  LogWalker(const Flow& flow, const gamelog::RclRecord& text)
      : flow_(flow),
        record_(*flow.record),
        text_(text),
        sides_(assign_sides(record_, text)),
        synchronous_(record_.server.synch_mode) {}

  PerPlayer<Responsiveness> walk() {
    for (std::size_t i = 0; i + 1 < record_.frames(); ++i) {
      if (record_.time[i + 1] < record_.time[i]) break;  // another match begins
      sent_ = {};
      collect(i);
      const bool match_goes_on = flow_.phase[i + 1] != Phase::kOver;
      for (std::size_t slot = 0; slot < gamelog::kSlots && match_goes_on; ++slot) evaluate(i, slot);
    }
    return players_;
  }

 private:
  // Lines are in the order of the clock; those before the first frame belong to no step.
  void collect(std::size_t frame) {
    while (line_ < text_.lines.size()) {
      const gamelog::RclLine& line = text_.lines[line_];
      const int order = clock_order(line, record_, frame);
      if (order > 0) return;
      ++line_;
      if (order < 0 || line.source != gamelog::RclSource::kPlayer) continue;
      if (sides_[line.team] < 0) continue;

      const std::size_t slot = base::index(sides_[line.team]) * kTeamSize + line.unum - 1U;
      add_datagram(text_.text_of(line), sent_[slot], players_[slot]);
    }
  }

  int increase(std::size_t entry, gamelog::Counter counter) const {
    const auto& counters = record_.players.counters;
    const std::size_t index = base::index(counter);
    return counters[entry + gamelog::kSlots][index] - counters[entry][index];
  }

  void evaluate(std::size_t frame, std::size_t slot) {
    const std::size_t entry = entry_of(frame, slot);
    if (!gamelog::is_enabled(record_, entry)) return;
    if (!gamelog::is_enabled(record_, entry + gamelog::kSlots)) return;

    const SentCommands& sent = sent_[slot];
    Responsiveness& player = players_[slot];
    ++player.steps;
    player.answered += sent.datagrams > 0;
    player.silent += synchronous_ ? sent.count(CommandKind::kDone) == 0 : sent.datagrams == 0;

    // While the clock is stopped, only turns have an effect, and players do not need them.
    const bool could_act =
        (record_.players.state[entry] & kImmobile) == 0 && flow_.phase[frame] != Phase::kStopped;
    const bool idle = sent.body == 0;
    player.no_body_command += idle && could_act;
    player.several_body += sent.body > 1;
    if (was_double_[slot] ? idle : (sent.body > 1 && was_idle_[slot])) ++player.late_steps;
    was_double_[slot] = sent.body > 1;
    was_idle_[slot] = idle && could_act;

    const auto rejected = [&](CommandKind kind, gamelog::Counter counter) {
      return std::max(0, sent.count(kind) - increase(entry, counter));
    };
    player.rejected_kicks += rejected(CommandKind::kKick, gamelog::Counter::kKick);
    player.rejected_turn_necks += rejected(CommandKind::kTurnNeck, gamelog::Counter::kTurnNeck);
    if (record_.version >= gamelog::RcgVersion::kV4) {
      player.rejected_tackles += rejected(CommandKind::kTackle, gamelog::Counter::kTackle);
    }
  }

  const Flow& flow_;
  const gamelog::MatchRecord& record_;
  const gamelog::RclRecord& text_;
  std::array<std::int8_t, 256> sides_;
  bool synchronous_;
  std::size_t line_ = 0;
  PerPlayer<SentCommands> sent_ = {};
  PerPlayer<Responsiveness> players_ = {};
  PerPlayer<bool> was_double_ = {};
  PerPlayer<bool> was_idle_ = {};
};

}  // namespace

std::array<std::int8_t, 256> assign_sides(const gamelog::MatchRecord& record,
                                          const gamelog::RclRecord& text) {
  std::array<std::int8_t, 256> sides;
  sides.fill(-1);

  const auto& [left, right] = record.final_teams();
  bool found = false;
  for (std::size_t i = 0; i < text.teams.size() && i < sides.size(); ++i) {
    if (text.teams[i] == left.name && left.name != right.name) sides[i] = 0;
    if (text.teams[i] == right.name && left.name != right.name) sides[i] = 1;
    found = found || sides[i] >= 0;
  }

  if (!found) {
    sides[0] = 0;
    sides[1] = 1;
  }
  return sides;
}

PerPlayer<Responsiveness> measure_responsiveness(const Flow& flow, const gamelog::RclRecord& text) {
  return LogWalker(flow, text).walk();
}

PerPlayer<Attention> measure_attention(const gamelog::MatchRecord& record) {
  constexpr float kNormal = 90.0F;
  constexpr float kWide = 150.0F;
  PerPlayer<Attention> result;

  for (std::size_t i = 0; i < record.frames(); ++i) {
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      const std::size_t entry = entry_of(i, slot);
      if (!gamelog::is_enabled(record, entry)) continue;
      Attention& player = result[slot];
      const float width = record.players.view_width[entry];

      ++player.frames;
      ++(width < kNormal ? player.narrow : width < kWide ? player.normal : player.wide);
      player.mean_view_width += width;
      player.low_quality += record.players.high_quality[entry] == 0;
      player.pointing += !std::isnan(record.players.pointing_at[entry].x);
      player.counted = record.players.counters[entry];

      const int target = record.players.attention[entry];
      if (target < 0) continue;
      ++player.attentive;
      ++player.targets[base::index(target)];
    }
  }

  for (Attention& player : result) {
    if (player.frames > 0) player.mean_view_width /= player.frames;
  }
  return result;
}

}  // namespace cls::analysis
