// Result table of `cls match`.
#include "cli/match/match_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>

#include "base/median.h"
#include "base/text/counted.h"
#include "base/text/wrap_text.h"
#include "cli/support/troubleshooting.h"
#include "match/result/late_warnings.h"
#include "process/command_plan.h"
#include "proxy/playmaker/playmaker_errors.h"

namespace cls::cli {
namespace {

using match::MatchResult;
using match::PlayerResult;
using match::TeamResult;

constexpr std::size_t kMaxWidth = 80;
constexpr std::size_t kRowWidth = 62;

std::int64_t total(const TeamResult& team,
                   const std::function<std::int64_t(const PlayerResult&)>& value) {
  std::int64_t sum = 0;
  for (const PlayerResult& player : team.players) sum += value(player);
  return sum;
}

std::int64_t commands(const TeamResult& team, const std::string& kind) {
  return total(team, [&](const PlayerResult& player) {
    const auto found = player.commands.find(kind);
    return found == player.commands.end() ? 0 : found->second;
  });
}

// Two latency figures of a team: of the slowest player (`worst`) or the median player.
std::string latency(const TeamResult& team, double match::RpcLatency::*first,
                    double match::RpcLatency::*second, bool worst) {
  const auto figure = [&](double match::RpcLatency::*which) {
    std::vector<double> values;
    for (const PlayerResult& player : team.players) values.push_back(player.rpc_us.*which);
    return worst ? *std::ranges::max_element(values) : base::median(values);
  };
  if (team.players.empty()) return "-";
  return fmt::format("{:.0f} / {:.0f} us", figure(first), figure(second));
}

// run:COMMAND may be long.
std::string shortened(const std::string& text) {
  constexpr std::size_t kWidth = 18;
  if (text.size() <= kWidth) return text;
  return fmt::format("{}...", std::string_view(text).substr(0, kWidth - 3));
}

// A line with its indentation; what follows a fold is indented by four.
std::string folded(std::string_view line, std::size_t width) {
  constexpr std::size_t kIndent = 4;
  std::string text = base::wrap_text(line, width);
  if (text.find('\n') == std::string::npos) return text;
  const std::size_t first = text.find('\n') + 1;
  return text.substr(0, first) + std::string(kIndent, ' ') +
         base::wrap_text(line.substr(first), width, kIndent);
}

class Rows {
 public:
  Rows(const MatchResult& result, std::size_t width)
      : result_(result), narrow_(width < kRowWidth) {}

  // On a narrow terminal the values are below their label.
  void add(std::string_view label, const std::string& left, const std::string& right) {
    if (!narrow_) {
      fmt::format_to(std::back_inserter(text_), "  {:<22} {:>18} {:>18}\n", label, left, right);
      return;
    }
    if (!label.empty()) fmt::format_to(std::back_inserter(text_), "  {}\n", label);
    fmt::format_to(std::back_inserter(text_), "{:>19} {:>19}\n", left, right);
  }
  void add(std::string_view label, const std::function<std::int64_t(const TeamResult&)>& value) {
    // External teams have no per-player counts.
    const auto text = [&value](const TeamResult& team) {
      return team.players.empty() ? "-" : fmt::to_string(value(team));
    };
    add(label, text(result_.left), text(result_.right));
  }
  std::string take() { return std::move(text_); }

 private:
  const MatchResult& result_;
  bool narrow_;
  std::string text_;
};

std::string score_line(const MatchResult& result) {
  std::string line = fmt::format("{} {} : {} {}", result.left.name, result.left.score,
                                 result.right.score, result.right.name);
  if (result.left.penalty_score && result.right.penalty_score) {
    line += fmt::format(" ({} : {} on penalties)", *result.left.penalty_score,
                        *result.right.penalty_score);
  }
  return line;
}

std::string goals_line(const MatchResult& result, std::size_t width) {
  if (result.goals.empty()) return {};
  std::string line = "  goals:";
  for (const auto& goal : result.goals) {
    const TeamResult& team = goal.side == soccer::Side::kLeft ? result.left : result.right;
    fmt::format_to(std::back_inserter(line), " {} {}", goal.cycle, team.name);
    if (goal.unum > 0) fmt::format_to(std::back_inserter(line), " {}", goal.unum);
    line += &goal == &result.goals.back() ? "" : ",";
  }
  return folded(line, width) + "\n";
}

std::string missed(const TeamResult& team) {
  if (team.players.empty()) return "-";
  return fmt::format("{}, {}",
                     total(team, [](const PlayerResult& player) { return player.missed; }),
                     total(team, [](const PlayerResult& player) { return player.late; }));
}

std::int64_t actions(const TeamResult& team, std::string_view outcome) {
  return total(team, [outcome](const PlayerResult& player) {
    std::int64_t sum = 0;
    for (const auto& [kind, outcomes] : player.actions) {
      const auto found = outcomes.find(std::string(outcome));
      if (found != outcomes.end()) sum += found->second;
    }
    return sum;
  });
}

// Requested actions by outcome; those that no proxy can execute only if there were any.
void add_actions(Rows& rows, const MatchResult& result) {
  rows.add("actions executed", [](const TeamResult& team) { return actions(team, "executed"); });

  const auto rest = [](const TeamResult& team) {
    if (team.players.empty()) return std::string("-");
    return fmt::format("{}, {}", actions(team, "failed"), actions(team, "skipped"));
  };
  rows.add("failed, skipped", rest(result.left), rest(result.right));
  const auto wrong = [](const TeamResult& team) {
    return actions(team, "invalid") + actions(team, "unimplemented");
  };
  if (wrong(result.left) + wrong(result.right) > 0) rows.add("invalid or unknown", wrong);
}

// Shown only if there was a reconnect.
void add_reconnects(Rows& rows, const MatchResult& result) {
  const auto count = [](const TeamResult& team) {
    return total(team, [](const PlayerResult& player) { return player.reconnects; });
  };
  if (count(result.left) + count(result.right) > 0) rows.add("reconnects", count);
}

// Losses that occur only when the server does not wait.
void add_losses(Rows& rows) {
  using Count = std::int64_t PlayerResult::*;
  const std::pair<const char*, Count> losses[] = {{"undecided cycles", &PlayerResult::undecided},
                                                  {"late commands", &PlayerResult::lost_commands},
                                                  {"late wake-ups", &PlayerResult::late_wakeups}};
  for (const auto& [label, count] : losses) {
    rows.add(label, [count = count](const TeamResult& team) {
      return total(team, [count](const PlayerResult& player) { return player.*count; });
    });
  }
}

std::string server_line(const MatchResult& result, std::size_t width) {
  std::string line = fmt::format("  {}", result.server_kind);
  if (!result.server_version.empty()) line += fmt::format(" {}", result.server_version);
  if (result.server_seed) line += fmt::format(", server seed {}", *result.server_seed);
  line += fmt::format(", missed cycles: {}", result.server_missed_cycles);
  if (result.server_cpu_seconds)
    line += fmt::format(", {:.2f} s of CPU", *result.server_cpu_seconds);
  return folded(line, width) + "\n";
}

// The time of play, and that before it where one waits for it.
std::string speed_line(const MatchResult& result, std::size_t width) {
  constexpr double kLongStart = 2.0;
  const double rate = result.cycles_per_second;
  const double play = rate > 0.0 ? result.cycles / rate : result.wall_seconds;
  const double start = result.wall_seconds - play;
  const std::string line = fmt::format(
      "  {} cycles in {:.1f} s ({:.0f} cycles/s){}, {}, seed {}{}", result.cycles, play, rate,
      start >= kLongStart ? fmt::format(", {:.1f} s for start and end", start) : "", result.mode,
      result.seed, result.deterministic ? "" : ", not deterministic");
  return folded(line, width) + "\n";
}

std::string figures(const MatchResult& result, std::size_t width) {
  Rows rows(result, width);
  rows.add("", result.left.name, result.right.name);
  rows.add("playmaker", shortened(result.left.endpoint), shortened(result.right.endpoint));
  rows.add("decisions", [](const TeamResult& team) {
    return total(team, [](const PlayerResult& player) { return player.decisions; });
  });
  rows.add("missed (late)", missed(result.left), missed(result.right));
  add_reconnects(rows, result);

  using Latency = match::RpcLatency;
  rows.add("rpc p50 / p95", latency(result.left, &Latency::p50, &Latency::p95, false),
           latency(result.right, &Latency::p50, &Latency::p95, false));
  rows.add("rpc worst p99 / max", latency(result.left, &Latency::p99, &Latency::max, true),
           latency(result.right, &Latency::p99, &Latency::max, true));

  add_actions(rows, result);
  for (const char* kind : {"kick", "dash", "turn", "tackle", "catch"}) {
    rows.add(kind, [kind](const TeamResult& team) { return commands(team, kind); });
  }
  if (result.mode != "lockstep") add_losses(rows);

  rows.add("cpu seconds", fmt::format("{:.2f}", result.left.cpu_seconds),
           fmt::format("{:.2f}", result.right.cpu_seconds));
  return rows.take();
}

// The Playmakers of a mixed side.
std::string parts(const TeamResult& team, std::size_t width) {
  std::string text;
  for (const auto& part : team.parts) {
    fmt::format_to(
        std::back_inserter(text),
        "  {} {}: {}\n    {}, {} missed, p50 {:.0f} us, p99 {:.0f} us, {:.2f} s of CPU\n",
        team.name, part.agents, base::wrap_text(part.endpoint, width, 4),
        base::counted(part.decisions, "decision"), part.missed, part.rpc_us.p50, part.rpc_us.p99,
        part.cpu_seconds);
  }
  return text.empty() ? text : text + "\n";
}

// What a side's Playmaker answered with an error, and how to ask it again.
std::string errors(const MatchResult& result, const TeamResult& team, std::size_t width) {
  if (!team.errors.first) return {};

  const auto& first = *team.errors.first;
  std::string text = fmt::format("  {}: {}, the first at cycle {} ({}, {})\n    {}\n", team.name,
                                 base::counted(team.errors.count, "RPC error"), first.cycle,
                                 first.rpc, proxy::agent_name(first.unum),
                                 base::wrap_text(first.status + ": " + first.message, width, 4));

  if (!first.recording.empty()) {
    fmt::format_to(std::back_inserter(text), "    try again: cls test --replay {} {}\n",
                   process::shell_quoted(result.folder + "/" + first.recording),
                   process::shell_quoted(team.endpoint));
  }
  return text;
}

// The first exception that each program printed; where errors() has its text, only its log.
std::string exceptions(const MatchResult& result, std::size_t width) {
  std::string text;
  for (const auto& process : result.processes) {
    if (process.exception.empty()) continue;
    if (!is_reported(result, process.exception)) {
      text += "  " + base::wrap_text(process.name + ": " + process.exception, width, 2) + "\n";
    }
    fmt::format_to(std::back_inserter(text), "    output is in {}/{}\n", result.folder,
                   process.log);
  }
  return text;
}

// A match without a cycle has no score and no figures.
std::string refusal(const MatchResult& result, std::size_t width) {
  std::string hint = troubleshooting_hint(result.end_reason);
  for (const auto& process : result.processes) {
    const std::string remedy = match::remedy_of(process.exception);
    if (!remedy.empty()) hint = "remedy: " + remedy;
  }
  return fmt::format("invalid match: {} before the first cycle\n  {}\n{}  {}/\n",
                     name(result.end_reason), base::wrap_text(hint, width, 2),
                     exceptions(result, width), result.folder);
}

// The command that shows the match; nothing for a match without a game log.
std::string watch_line(const MatchResult& result) {
  if (result.rcg.empty()) return "";
  return fmt::format("  cls watch {}\n", process::shell_quoted(result.folder));
}

}  // namespace

std::string match_report(const MatchResult& result, bool color, std::size_t width) {
  width = std::min(width, kMaxWidth);
  if (!result.valid() && result.steps == 0) return refusal(result, width);

  const std::string score = score_line(result);
  std::string text;
  if (!result.valid()) {  // its score does not count
    text = fmt::format("invalid match: {} at cycle {}\n  {}\n  score until then: {}\n",
                       name(result.end_reason), result.cycles,
                       base::wrap_text(troubleshooting_hint(result.end_reason), width, 2), score);
  } else {
    text = color ? fmt::format("\x1b[1m{}\x1b[0m\n", score) : score + "\n";
  }

  text += goals_line(result, width);
  text += errors(result, result.left, width) + errors(result, result.right, width) +
          exceptions(result, width) + "\n";
  const bool played = result.valid() || result.cycles > 0;
  if (played) {
    text += figures(result, width) + "\n" + parts(result.left, width) + parts(result.right, width);
  }

  text += speed_line(result, width);
  if (result.speed && result.valid()) text += folded("  " + describe(*result.speed), width) + "\n";
  if (result.mode != "lockstep") text += server_line(result, width);
  fmt::format_to(std::back_inserter(text), "  {}/\n", result.folder);
  return text + watch_line(result);
}

}  // namespace cls::cli
