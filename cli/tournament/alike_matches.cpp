// Compares the commands of two matches by their text logs.
#include "cli/tournament/alike_matches.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "cli/logs/agent_commands.h"
#include "cli/logs/find_log.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using tournament::ScheduledMatch;

// Connections have the names of the teams; all other commands are the same for teams that play the
// same.
bool names_team(const AgentCommand& command) {
  return command.text.starts_with("(init ") || command.text.starts_with("(reconnect ");
}

// Sorted: agents send theirs in any order within a cycle.
std::vector<AgentCommand> commands_in(const gamelog::RclRecord& log) {
  std::vector<AgentCommand> commands = agent_commands(log);
  std::erase_if(commands, names_team);
  std::ranges::stable_sort(commands);
  return commands;
}

std::optional<gamelog::RclRecord> text_log_of(const fs::path& match) {
  const auto found = find_log(match.string());
  return found ? read_text_log(*found) : std::nullopt;
}

bool same_score(const ScheduledMatch& a, const ScheduledMatch& b) {
  return a.outcome->left_score == b.outcome->left_score &&
         a.outcome->right_score == b.outcome->right_score;
}

}  // namespace

bool have_same_commands(const fs::path& match, const fs::path& other) {
  const auto log = text_log_of(match);
  const auto other_log = log ? text_log_of(other) : std::nullopt;
  if (!other_log || log->lines.empty()) return false;
  return commands_in(*log) == commands_in(*other_log);
}

bool AlikeSamples::is_alike(std::span<const ScheduledMatch> sample) const {
  // Of a pair the two matches, of a quartet those with NEW and those with BASE.
  const std::size_t half = sample.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    const ScheduledMatch& a = sample[i];
    const ScheduledMatch& b = sample[i + half];
    if (!a.outcome->played() || !b.outcome->played() || !same_score(a, b)) return false;
    if (a.outcome->folder.empty() || b.outcome->folder.empty()) return false;
    if (!have_same_commands(folder_ / a.outcome->folder, folder_ / b.outcome->folder)) return false;
  }
  return true;
}

std::string AlikeSamples::look_at(std::span<const ScheduledMatch> matches) {
  const auto size = static_cast<std::size_t>(matches_in_sample(comparison_));
  std::string line;
  for (std::size_t at = samples_ * size; at + size <= matches.size(); at += size) {
    const auto sample = matches.subspan(at, size);
    if (!all_have_outcomes(sample)) break;

    ++samples_;
    if (!is_alike(sample)) continue;
    ++alike_;
    if (samples_ == 1) {
      const auto& teams = comparison_.config.competition.teams;
      std::string_view sample_name = tournament::sample_name(comparison_);
      sample_name.remove_suffix(1);  // the name is a plural
      line = fmt::format(
          "{} and {} sent the same commands in all cycles of the first {}: what differs between "
          "them has no effect there",
          teams[0].name, teams[1].name, sample_name);
    }
  }
  return line;
}

std::string AlikeSamples::text() const {
  const auto& teams = comparison_.config.competition.teams;
  return fmt::format("in {} of {} {} {} and {} sent the same commands in all cycles", alike_,
                     samples_, sample_name(comparison_), teams[0].name, teams[1].name);
}

}  // namespace cls::cli
