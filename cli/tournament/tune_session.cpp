// Reads configurations, compares plans.
#include "cli/tournament/tune_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "cli/support/print_error.h"
#include "cli/terminal/terminal.h"
#include "league/schedule/schedule.h"
#include "match/terms/endpoint.h"
#include "match/terms/match_options.h"
#include "tournament/config/config_file.h"
#include "tournament/store/folder.h"
#include "tournament/tuning/candidate.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace match = match;
using namespace tournament;

// A side, or the endpoint of a team of cls.toml.
int add_opponent(TuneSetup& setup, const std::string& side) {
  TeamEntry entry{"", side};
  if (const int team = team_index(setup.conditions.competition, side); team >= 0) {
    entry = setup.conditions.competition.teams[base::index(team)];
  }

  const auto endpoint = match::parse_endpoint(entry.endpoint);
  if (!endpoint) return print_error(kBadConfig, "opponents: " + endpoint.error().message);
  if (entry.name.empty()) entry.name = match::default_team_name(*endpoint);
  const auto taken = [&](const std::string& name) {
    return name.starts_with("tune") ||
           std::ranges::any_of(setup.opponents,
                               [&](const TeamEntry& one) { return one.name == name; });
  };

  if (taken(entry.name)) {
    constexpr std::size_t kMaxStem = 10;
    entry.name = fmt::format("{}_op{}", entry.name.substr(0, kMaxStem), setup.opponents.size() + 1);
  }
  setup.opponents.push_back(std::move(entry));
  return kOk;
}

// Seeds of the first pairs of a comparison with this seed.
bool is_fresh(const TuneConfig& config, std::uint64_t seed, int generations) {
  std::set<std::uint64_t> used;
  for (int pairing = 1; pairing <= generations * config.pairs; ++pairing) {
    used.insert(pairing_seed(config.seed, pairing));
  }

  for (int pairing = 1; pairing <= config.verdict_pairs; ++pairing) {
    if (used.contains(pairing_seed(seed, pairing))) return false;
  }
  return true;
}

TestSettings test_of(const TuneConfig& config) {
  TestSettings test;
  test.measure = config.measure;
  test.max_goals = config.max_goals;
  test.goals1 = std::min(test.goals1, config.max_goals / 2.0);
  return test;
}

}  // namespace

int read_tune_config(const fs::path& folder, TuneConfig& config) {
  const fs::path file = folder / kTuneFile;
  const auto text = base::read_file(file);
  if (!text) {
    return print_error(kNoInput, "{}: not found; `cls tune init {}` writes one", file.string(),
                       folder.string());
  }

  ParsedTuneConfig parsed = parse_tune_config(*text, file.string());
  print_errors(kBadConfig, parsed.errors);
  if (!parsed.errors.empty()) return kBadConfig;
  config = std::move(parsed.config);
  if (config.file_template.empty()) return kOk;

  const fs::path path = folder / config.file_template;
  const auto content = base::read_file(path);
  if (!content) return print_error(kNoInput, "{}: cannot read", path.string());
  config.file_template = *content;
  for (const Parameter& parameter : config.parameters) {
    const std::string place = "{" + parameter.name + "}";
    if (config.file_template.find(place) == std::string::npos &&
        config.team.find(place) == std::string::npos) {
      return print_error(kBadConfig, "{}: does not use {}", path.string(), place);
    }
  }
  return kOk;
}

int make_tune_setup(const TournamentOptions& options, TuneSetup& setup) {
  TRY_STEP(read_tune_config(options.folder, setup.tune));

  ChosenConfig chosen = choose_conditions(options);
  if (chosen.exit_code != kOk) return chosen.exit_code;
  setup.conditions = std::move(chosen.config);
  if (setup.conditions.execution.folder.empty())
    setup.conditions.execution.folder = fs::absolute(options.folder);

  const bool book = !match_options(setup.conditions.conditions).book.empty();
  if (book != (setup.tune.measure == Measure::kValue)) {
    return print_error(kBadConfig,
                       book ? "with a book, tune.toml needs measure = \"value\""
                            : "tune.toml: measure = \"value\" needs a book, as in --book FILE");
  }

  if (is_given(options, "seed")) setup.tune.seed = setup.conditions.competition.seed;
  // Hundreds of match folders are of no use; --keep-logs all retains them.
  if (!is_given(options, "keep_logs")) setup.conditions.execution.keep_logs = KeepLogs::kFailed;
  for (const std::string& side : setup.tune.opponents) {
    TRY_STEP(add_opponent(setup, side));
  }
  return kOk;
}

int check_tune_plan(const fs::path& folder, const TuneConfig& config) {
  std::string plan;
  for (const std::string& line : plan_lines(config)) plan += line + "\n";

  const fs::path file = folder / kTunePlanFile;
  const auto before = base::read_file(file);
  if (!before) {
    const auto written = base::write_file(file, plan);
    return written ? kOk : print_error(kCannotCreate, written.error().message);
  }
  if (*before == plan) return kOk;

  const auto differs = std::mismatch(plan.begin(), plan.end(), before->begin(), before->end());
  const auto at = static_cast<std::size_t>(differs.first - plan.begin());
  const auto line_at = [&](const std::string& text) {
    const std::size_t end = std::min(at, text.size());
    const std::size_t begin = end == 0 ? 0 : text.rfind('\n', end - 1) + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
  };

  return print_error(kBadConfig,
                     "{}: another search has begun here: '{}', was '{}'; --force starts over",
                     folder.string(), line_at(plan), line_at(*before));
}

int make_verdict(const TuneSetup& setup, const Tuning& tuning, const fs::path& folder,
                 Comparison& comparison) {
  TournamentConfig& config = comparison.config;
  config = setup.conditions;
  config.competition.format = Format::kList;
  config.competition.rounds.reset();
  config.competition.swap_sides = true;
  config.competition.gauntlet.clear();
  config.competition.teams.clear();
  config.competition.seed = setup.tune.seed + 1;

  const int generations = static_cast<int>(tuning.history().size());
  while (!is_fresh(setup.tune, config.competition.seed, generations)) ++config.competition.seed;

  const auto& parameters = setup.tune.parameters;
  const Values start = values_at(parameters, start_point(parameters));
  for (const auto& [name, values] : {std::pair{"BEST", tuning.best()}, {"START", start}}) {
    TRY_INIT_OR(kCannotCreate, auto side,
                prepare_candidate(setup.tune, values,
                                  fs::absolute(folder) / kVerdictFolder / "files" / name));
    config.competition.teams.push_back({name, std::move(side)});
  }

  config.competition.teams.insert(config.competition.teams.end(), setup.opponents.begin(),
                                  setup.opponents.end());
  config.competition.matches = {{"BEST", "START"}};
  comparison.test = test_of(setup.tune);
  comparison.max_samples = setup.tune.verdict_pairs;
  return kOk;
}

std::optional<TuneVerdict> known_verdict(const TuneConfig& config, const fs::path& folder) {
  const fs::path verdict_folder = folder / kVerdictFolder;
  if (!holds_plan(verdict_folder)) return std::nullopt;
  auto state = read_tournament(verdict_folder);
  if (!state) return std::nullopt;

  Comparison comparison;
  comparison.config = std::move(state->config);
  comparison.test = test_of(config);
  comparison.max_samples = config.verdict_pairs;
  const ComparisonVerdict known = verdict(comparison, state->matches);
  return TuneVerdict{comparison_text(comparison, state->matches, stdout_width()),
                     std::string(verdict_name(known))};
}

}  // namespace cls::cli
