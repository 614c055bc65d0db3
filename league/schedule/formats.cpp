// The table of formats, and what a competition of each must have.
#include "league/schedule/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/text/suggestion.h"
#include "league/schedule/fixture_list.h"

namespace cls::league {
namespace {

constexpr std::size_t kMaxTeams = 1000;
constexpr double kMaxMatches = 1e6;

constexpr TieBreaker kSwissOrder[] = {TieBreaker::kBuchholz,        TieBreaker::kMedianBuchholz,
                                      TieBreaker::kSonnebornBerger, TieBreaker::kHeadToHead,
                                      TieBreaker::kGoalDifference,  TieBreaker::kGoals};

// With more rounds two teams would meet twice.
int max_swiss_rounds(const Competition& competition) {
  const int teams = competition.team_count();
  return teams % 2 == 0 ? teams - 1 : teams;
}

int swiss_rounds(const Competition& competition) {
  int rounds = 1;
  for (std::size_t reach = 1; reach < competition.teams.size(); reach *= 2) ++rounds;
  return std::min(rounds, max_swiss_rounds(competition));
}

void check_swiss(ErrorList& errors, const Competition& competition) {
  const int teams = competition.team_count();
  const int rounds = rounds_of(competition);
  errors.require(teams < 2 || rounds <= max_swiss_rounds(competition),
                 fmt::format("rounds = {}: {} teams can play at most {} Swiss rounds without "
                             "meeting twice",
                             rounds, teams, max_swiss_rounds(competition)));
}

void check_gauntlet(ErrorList& errors, const Competition& competition) {
  errors.require(!competition.gauntlet.empty(),
                 "format 'gauntlet' requires the key gauntlet with the teams that meet all others");
}

void check_list(ErrorList& errors, const Competition& competition) {
  errors.require(!competition.matches.empty(), "format 'list' requires the key matches");
}

void check_groups(ErrorList& errors, const Competition& competition) {
  const int groups = competition.groups;
  const int advance = competition.advance;
  const int teams = competition.team_count();
  const int smallest = teams / std::max(1, groups);
  errors.require(
      teams >= 2 * groups,
      fmt::format("{} groups require at least {} teams, there are {}", groups, 2 * groups, teams));
  errors.require(
      advance <= smallest,
      fmt::format("advance = {}: the smallest group has only {} teams", advance, smallest));
  errors.require(groups * advance >= 2,
                 "a knockout requires at least two teams; increase groups or advance");
}

void check_stages(ErrorList& errors, const Competition& competition) {
  errors.require(!competition.stages.empty(),
                 "format 'stages' requires [[stages]], each with a name");
  errors.require(!competition.rounds, "rounds: a stage has `legs` instead");

  std::vector<std::string> teams;
  for (const TeamEntry& team : competition.teams) teams.push_back(team.name);
  errors.add(stage_errors(competition.stages, teams));
}

double matches_of(const Competition& competition, double pairings) {
  return pairings * rounds_of(competition) * (competition.swap_sides ? 2 : 1);
}

double all_pairings(const Competition& competition) {
  const auto teams = static_cast<double>(competition.teams.size());
  return teams * (teams - 1) / 2;
}

double all_meet(const Competition& competition) {
  return matches_of(competition, all_pairings(competition));
}

double gauntlet_size(const Competition& competition) {
  const std::size_t pairings = competition.teams.size() * competition.gauntlet.size();
  return matches_of(competition, static_cast<double>(pairings));
}

double list_size(const Competition& competition) {
  return matches_of(competition, static_cast<double>(competition.matches.size()));
}

double stages_size(const Competition& competition) {
  double matches = 0;
  for (const Stage& stage : competition.stages) matches += all_pairings(competition) * stage.legs;
  return matches;
}

// In the order of Format.
constexpr std::array kFormats = {
    FormatRules{.format = Format::kRoundRobin,
                .name = "round-robin",
                .schedule = schedule_round_robin,
                .size = all_meet,
                .later = false},
    FormatRules{.format = Format::kGauntlet,
                .name = "gauntlet",
                .schedule = schedule_gauntlet,
                .check = check_gauntlet,
                .size = gauntlet_size,
                .later = false},
    FormatRules{.format = Format::kList,
                .name = "list",
                .schedule = schedule_list,
                .check = check_list,
                .size = list_size,
                .later = false},
    FormatRules{.format = Format::kGroups,
                .name = "groups",
                .schedule = schedule_groups,
                .check = check_groups,
                .size = all_meet},
    FormatRules{.format = Format::kKnockout,
                .name = "knockout",
                .schedule = schedule_single_elimination,
                .size = all_meet,
                .bracket_only = true},
    FormatRules{.format = Format::kDoubleElimination,
                .name = "double-elimination",
                .schedule = schedule_double_elimination,
                .size = all_meet,
                .bracket_only = true},
    FormatRules{.format = Format::kSwiss,
                .name = "swiss",
                .schedule = schedule_swiss,
                .check = check_swiss,
                .rounds = swiss_rounds,
                .byes = swiss_byes,
                .tie_breakers = kSwissOrder,
                .shows_opponents = true},
    FormatRules{.format = Format::kStages,
                .name = "stages",
                .schedule = schedule_stages,
                .check = check_stages,
                .size = stages_size,
                .adds_shoot_outs = true},
};

static_assert(std::ranges::is_sorted(kFormats, {}, &FormatRules::format));

std::string unknown_team(const Competition& competition, std::string_view key,
                         std::string_view name) {
  std::vector<std::string_view> known;
  for (const TeamEntry& team : competition.teams) known.push_back(team.name);
  const std::string_view near = base::nearest_name(name, known);
  return fmt::format("{}: unknown team '{}'{}", key, name,
                     near.empty() ? "" : fmt::format("; did you mean '{}'?", near));
}

void check_teams(ErrorList& errors, const Competition& competition) {
  const std::vector<TeamEntry>& teams = competition.teams;
  errors.require(teams.size() >= 2,
                 fmt::format("a tournament requires at least two teams, there {}; add [teams.NAME] "
                             "with an endpoint for each",
                             teams.empty() ? "is none" : "is one"));
  errors.require(
      teams.size() <= kMaxTeams,
      fmt::format("a tournament has at most {} teams, there are {}", kMaxTeams, teams.size()));

  std::set<std::string> seen;
  for (const TeamEntry& team : teams) {
    errors.require(seen.insert(team.name).second,
                   fmt::format("duplicate team name '{}'", team.name));
  }
}

void check_named_teams(ErrorList& errors, const Competition& competition) {
  const auto require_team = [&](std::string_view key, const std::string& team) {
    errors.require(team_index(competition, team) >= 0, unknown_team(competition, key, team));
  };
  for (const std::string& subject : competition.gauntlet) require_team("gauntlet", subject);

  for (const auto& pairing : competition.matches) {
    for (const std::string& team : pairing) require_team("matches", team);
    errors.require(
        pairing.size() == 2 && pairing[0] != pairing[1],
        fmt::format("matches: [{}] does not name two different teams", fmt::join(pairing, ", ")));
  }
}

}  // namespace

std::span<const FormatRules> formats() { return kFormats; }

const FormatRules& rules_of(const Competition& competition) {
  return kFormats[base::index(competition.format)];
}

std::string_view name(Format format) { return kFormats[base::index(format)].name; }

int rounds_of(const Competition& competition) {
  if (competition.rounds) return *competition.rounds;
  const auto rounds = rules_of(competition).rounds;
  return rounds == nullptr ? 1 : rounds(competition);
}

std::vector<TieBreaker> tie_breakers_of(const Competition& competition) {
  if (!competition.tie_breakers.empty()) return competition.tie_breakers;
  const auto breakers = rules_of(competition).tie_breakers;
  return {breakers.begin(), breakers.end()};
}

std::vector<std::string> competition_errors(const Competition& competition) {
  ErrorList errors;
  check_teams(errors, competition);
  check_named_teams(errors, competition);

  const FormatRules& rules = rules_of(competition);
  if (rules.check != nullptr) rules.check(errors, competition);
  errors.require(competition.stages.empty() || competition.format == Format::kStages,
                 fmt::format("[[stages]] belong to format 'stages', not to '{}'", rules.name));

  const double matches = rules.size == nullptr ? 0.0 : rules.size(competition);
  errors.require(matches <= kMaxMatches,
                 fmt::format("a schedule of about {:.0f} matches; at most {:.0f} are possible",
                             matches, kMaxMatches));
  return errors.take();
}

}  // namespace cls::league
