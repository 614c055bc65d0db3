// Parses lines of results.
#include "tournament/store/results_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/number_text.h"
#include "base/text/suggestion.h"
#include "base/text/trimmed.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

constexpr const char* kResultForm =
    "must be TEAM GOALS:GOALS TEAM, as in 'RED 2:1 BLUE', or "
    "'RED 2:2 (4:3) BLUE' with a shoot-out";

Result<int> team_of(const TournamentConfig& config, const std::string& name) {
  const int team = team_index(config.competition, name);
  if (team >= 0) return team;
  std::vector<std::string_view> known;
  for (const TeamEntry& one : config.competition.teams) known.push_back(one.name);
  return Error{fmt::format("unknown team '{}'{}", name, base::did_you_mean(name, known))};
}

void swap_sides(Outcome& outcome) {
  std::swap(outcome.left_score, outcome.right_score);
  std::swap(outcome.left_penalties, outcome.right_penalties);
}

}  // namespace

std::optional<std::pair<int, int>> parse_goals(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == text.npos) return std::nullopt;
  const auto first = base::parse_int(text.substr(0, colon));
  const auto second = base::parse_int(text.substr(colon + 1));
  if (!first || !second || *first < 0 || *second < 0) return std::nullopt;
  return std::pair(*first, *second);
}

Result<void> ResultsFile::add(std::string_view line, const std::string& stage,
                              const TournamentConfig& config) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> fields;
  for (std::string field; stream >> field;) fields.push_back(std::move(field));
  if (fields.size() != 3 && fields.size() != 4) return Error{kResultForm};

  Entry entry;
  const auto goals = parse_goals(fields[1]);
  if (!goals) return Error{kResultForm};
  entry.outcome.left_score = goals->first;
  entry.outcome.right_score = goals->second;
  if (fields.size() == 4) {
    const std::string& inner = fields[2];
    const bool enclosed = inner.size() > 2 && inner.front() == '(' && inner.back() == ')';
    const auto penalties = enclosed ? parse_goals(inner.substr(1, inner.size() - 2)) : std::nullopt;
    if (!penalties) return Error{kResultForm};
    if (goals->first != goals->second) return Error{"a shoot-out follows a level match only"};
    entry.outcome.left_penalties = penalties->first;
    entry.outcome.right_penalties = penalties->second;
  }

  TRY_INIT(const int left, team_of(config, fields.front()));
  TRY_INIT(const int right, team_of(config, fields.back()));
  if (left == right) return Error{fmt::format("'{}' meets itself", fields.front())};

  entry.left = left;
  if (!entries_.emplace(Key{stage, std::minmax({left, right})}, entry).second) {
    return Error{
        fmt::format("a second result of {} and {} in this stage", fields.front(), fields.back())};
  }
  return {};
}

Result<ResultsFile> ResultsFile::parse(std::string_view text, const std::string& file,
                                       const TournamentConfig& config) {
  ResultsFile results;
  results.file_ = file;
  std::string stage;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
    const std::string_view line = base::trimmed(whole.substr(0, whole.find('#')));
    if (line.empty()) continue;

    if (line.front() == '[') {
      if (line.back() != ']') {
        return Error{fmt::format("{}:{}: a stage ends in ']'", file, number)};
      }
      stage = line.substr(1, line.size() - 2);
      continue;
    }

    if (const auto added = results.add(line, stage, config); !added) {
      return Error{fmt::format("{}:{}: {}", file, number, added.error().message)};
    }
  }
  return results;
}

Result<ResultsFile> ResultsFile::read(const std::filesystem::path& file,
                                      const TournamentConfig& config) {
  const auto text = base::read_text(file);
  if (!text) return Error{fmt::format("cannot read {}", file.string())};
  return parse(*text, file.string(), config);
}

Result<Outcome> ResultsFile::find(const TournamentConfig& config, const Fixture& fixture) const {
  const auto found = entries_.find({fixture.stage, std::minmax({fixture.left, fixture.right})});
  if (found == entries_.end()) {
    const auto team = [&config](int index) { return config.competition.team(index); };
    return Error{fmt::format("{}: no result of {} and {}, match {}, below [{}]", file_,
                             team(fixture.left), team(fixture.right), fixture.index,
                             fixture.stage)};
  }
  Outcome outcome = found->second.outcome;
  if (fixture.left != found->second.left) swap_sides(outcome);
  return outcome;
}

}  // namespace cls::tournament
