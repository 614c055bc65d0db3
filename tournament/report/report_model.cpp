// Counts matches and computes tables and ratings once for all formats.
#include "tournament/report/report_model.h"

#include <fmt/format.h>

#include <utility>

#include "process/command_plan.h"
#include "tournament/store/match_attempt.h"

namespace cls::tournament {
namespace {

std::string folder_name(const std::filesystem::path& folder) {
  const std::filesystem::path path = std::filesystem::absolute(folder).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace

std::string tournament_name(const TournamentConfig& config, const std::filesystem::path& folder) {
  return config.report.name.empty() ? folder_name(folder) : config.report.name;
}

MatchCounts count(std::span<const ScheduledMatch> matches) {
  MatchCounts counts;
  counts.scheduled = static_cast<int>(matches.size());
  for (const ScheduledMatch& match : matches) {
    if (!match.outcome) {
      ++counts.open;
    } else if (match.outcome->annulled) {
      ++counts.annulled;
    } else if (match.outcome->forfeit) {
      ++counts.forfeits;
    } else {
      ++(match.outcome->played() ? counts.finished : counts.invalid);
    }
  }
  return counts;
}

std::string counts_text(const MatchCounts& counts) {
  std::string text = fmt::format("{} of {} matches done", counts.done(), counts.scheduled);
  const char* separator = ", of these ";
  if (counts.forfeits > 0) {
    text += fmt::format("{}{} forfeited", std::exchange(separator, ", "), counts.forfeits);
  }
  if (counts.annulled > 0) {
    text += fmt::format("{}{} annulled", std::exchange(separator, ", "), counts.annulled);
  }
  if (counts.invalid > 0) text += fmt::format("{}{} INVALID", separator, counts.invalid);
  return text;
}

Report make_report(const TournamentConfig& config, std::span<const ScheduledMatch> matches,
                   const std::filesystem::path& folder) {
  const Competition& competition = config.competition;
  Report report;
  report.config = &config;
  report.matches = matches;
  report.folder = report.link_base = folder;
  report.name = tournament_name(config, folder);
  report.counts = count(matches);
  report.complete = report.counts.open == 0 && report.counts.scheduled > 0 &&
                    next_fixtures(competition, matches).empty();
  report.tables = tables(competition, matches);
  report.bracket = bracket(competition, matches);
  report.byes = byes(competition, matches);

  report.head_to_heads = head_to_heads(matches);
  report.ratings = fit_bradley_terry(competition.team_count(), results_of(report.head_to_heads));
  for (int team = 0; team < competition.team_count(); ++team) {
    report.records.push_back(record_of(team, report.head_to_heads));
  }

  report.playmakers = playmaker_figures(competition.teams.size(), matches);
  report.hosts = host_figures(matches);
  report.timetable = timetable(config, matches, std::time(nullptr));
  // read_tournament() reports a file that cannot be read.
  if (auto pauses = read_pauses(folder)) report.pauses = *std::move(pauses);
  return report;
}

std::vector<std::string> first_teams(const Report& report) {
  std::vector<std::string> first;
  if (report.tables.empty()) return first;
  for (const Standing& one : report.tables.back().standings) {
    if (one.rank == 1) first.push_back(report.team(one.team));
  }
  return first;
}

std::optional<HeadToHead> find_head_to_head(const Report& report, int first, int second) {
  for (const HeadToHead& head_to_head : report.head_to_heads) {
    if (head_to_head.first == first && head_to_head.second == second) return head_to_head;
    if (head_to_head.first == second && head_to_head.second == first) return reversed(head_to_head);
  }
  return std::nullopt;
}

bool failed(const ScheduledMatch& match) {
  return match.outcome && !match.outcome->played() && !match.outcome->annulled &&
         !(match.decision && match.outcome->forfeit);
}

std::string rerun_command(const TournamentConfig& config, const Fixture& fixture) {
  return process::to_shell(match_plan(config, fixture, "cls", ""));
}

std::string score_text(const TournamentConfig& config, const ScheduledMatch& match, bool swapped) {
  const bool by_play = match.outcome && match.outcome->played();
  const bool adds_shoot_outs = rules_of(config.competition).adds_shoot_outs;
  if (!adds_shoot_outs || !by_play || !had_shoot_out(*match.outcome)) {
    return score_text(match, swapped);
  }
  const Outcome& outcome = *match.outcome;
  const std::string left = fmt::format("({}+{})", outcome.left_score, *outcome.left_penalties);
  const std::string right = fmt::format("({}+{})", outcome.right_score, *outcome.right_penalties);
  return swapped ? fmt::format("{} - {}", right, left) : fmt::format("{} - {}", left, right);
}

namespace {

// `played`: a match to be played again has been.
std::string text_of(const MatchDecision& decision, bool played) {
  switch (decision.kind) {
    case DecisionKind::kAnnul:
      return "annulled";
    case DecisionKind::kReplay:
      return played ? "played again" : "to be played again";
    case DecisionKind::kAward:
      return fmt::format("awarded {}:{}", decision.left_score, decision.right_score);
    case DecisionKind::kAsPlayed:
      return "counts as played";
    case DecisionKind::kWithdraw:
      return "withdrawn";
    case DecisionKind::kOrder:
      return "order";
  }
  return {};
}

}  // namespace

std::string decision_text(const ScheduledMatch& match, std::size_t number) {
  const bool played = match.outcome || number + 1 < match.history.size();
  return text_of(match.history[number], played);
}

std::string decision_text(const ScheduledMatch& match) {
  return match.decision ? text_of(*match.decision, match.outcome.has_value()) : std::string();
}

std::string history_text(const ScheduledMatch& match) {
  std::string text;
  if (is_by_withdrawal(match)) text = decision_text(match) + ", withdrawn";
  for (std::size_t i = 0; i < match.history.size(); ++i) {
    if (is_about_teams(match.history[i].kind)) continue;
    if (!text.empty()) text += "; ";
    text += decision_text(match, i);
    const std::string& before = match.history[i].before;
    if (!before.empty() && before != "annulled") text += ", was " + before;
  }
  return text;
}

std::string score_text(const ScheduledMatch& match, bool swapped) {
  if (!match.outcome) return "-";
  const Outcome& outcome = *match.outcome;
  std::string text = result_text(outcome, swapped);
  if (outcome.counts() && outcome.forfeit) text += match.decision ? " (decision)" : " (forfeit)";
  return text;
}

std::string stage_text(const Fixture& fixture) {
  return fixture.stage.empty() ? fmt::format("round {}", fixture.round) : fixture.stage;
}

}  // namespace cls::tournament
