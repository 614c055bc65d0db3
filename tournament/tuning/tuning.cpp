// Optimizer and generations.
#include "tournament/tuning/tuning.h"

#include <fmt/format.h>

#include <algorithm>

#include "tournament/store/folder.h"
#include "tournament/tuning/candidate.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;

SearchSpace space_of(const TuneConfig& config) {
  SearchSpace space;
  space.start = start_point(config.parameters);
  for (const Parameter& parameter : config.parameters) {
    constexpr double kCell = 0.5;  // a step of an integer is half a cell at least
    space.steps.push_back(parameter.step);
    const double cells = parameter.max - parameter.min + 1;
    space.min_steps.push_back(parameter.integer ? kCell / cells : 0.0);
  }
  space.valid = [parameters = config.parameters,
                 constraints = config.constraints](const Point& point) {
    return satisfies(values_at(parameters, point), constraints);
  };
  return space;
}

std::unique_ptr<Optimizer> make_optimizer(const TuneConfig& config) {
  return config.method == TuneMethod::kCmaEs
             ? make_cma_es(space_of(config), config.population, config.seed)
             : make_spsa(space_of(config), config.generations, config.seed);
}

Estimate score_of(const std::vector<RaceResult>& results) {
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (const RaceResult& result : results) {
    for (const double value : result.pairs) {
      sum += value;
      squares += value * value;
      ++count;
    }
  }
  if (count == 0) return {};
  const double mean = sum / count;
  return estimate(mean, std::max(0.0, squares / count - mean * mean), count);
}

}  // namespace

Tuning::Tuning(TuneConfig config)
    : config_(std::move(config)), optimizer_(make_optimizer(config_)) {
  ask();
}

void Tuning::ask() {
  candidates_.clear();
  for (const Point& point : optimizer_->ask()) {
    candidates_.push_back(values_at(config_.parameters, point));
  }
}

Race Tuning::race() const {
  return {static_cast<int>(history_.size()) + 1, static_cast<int>(candidates_.size()),
          static_cast<int>(config_.opponents.size())};
}

void Tuning::record(std::vector<RaceResult> results) {
  optimizer_->tell(ranking_values(config_, results));
  Generation generation;
  generation.candidates = std::move(candidates_);
  generation.score = score_of(results);
  generation.results = std::move(results);
  generation.coordinates = optimizer_->best();
  generation.spread = optimizer_->spread();
  generation.best = values_at(config_.parameters, generation.coordinates);
  history_.push_back(std::move(generation));
  ask();
}

Values Tuning::best() const { return values_at(config_.parameters, optimizer_->best()); }

std::vector<Interval> Tuning::spread() const {
  const Point center = optimizer_->best();
  const Point spread = optimizer_->spread();
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i < center.size(); ++i) {
    const Parameter& parameter = config_.parameters[i];
    intervals.push_back(
        {value_at(parameter, center[i] - spread[i]), value_at(parameter, center[i] + spread[i])});
  }
  return intervals;
}

int Tuning::pairs_played() const {
  int sum = 0;
  const bool direct = config_.opponents.empty();
  for (const Generation& generation : history_) {
    for (const RaceResult& result : generation.results) {
      sum += static_cast<int>(result.pairs.size());
      if (direct) break;  // both candidates played the same pairs
    }
  }
  return sum;
}

double measured(const TuneConfig& config, double value) {
  return config.measure == Measure::kPoints ? value : (value - 0.5) * 2 * config.max_goals;
}

fs::path generation_folder(const fs::path& folder, int generation) {
  return folder / "generations" / fmt::format("{:04d}", generation);
}

base::Result<TournamentConfig> generation_config(const Tuning& tuning, const TournamentConfig& base,
                                                 const std::vector<TeamEntry>& opponents,
                                                 const fs::path& folder) {
  TournamentConfig config = base;
  Competition& competition = config.competition;
  competition.format = Format::kList;
  competition.rounds.reset();
  competition.swap_sides = true;
  competition.gauntlet.clear();
  competition.seed = tuning.config().seed;
  competition.teams.clear();

  const fs::path files = generation_folder(folder, tuning.race().generation) / "files";
  for (std::size_t i = 0; i < tuning.candidates().size(); ++i) {
    const std::string name = fmt::format("tune{}", i + 1);
    TRY_INIT(auto side, prepare_candidate(tuning.config(), tuning.candidates()[i], files / name));
    competition.teams.push_back({name, std::move(side)});
  }
  std::ranges::copy(opponents, std::back_inserter(competition.teams));
  competition.matches = {{competition.teams.front().name, competition.teams.back().name}};
  return config;
}

base::Result<void> replay_generations(Tuning& tuning, const fs::path& folder) {
  while (true) {
    const Race race = tuning.race();
    const fs::path one = generation_folder(folder, race.generation);
    if (!holds_plan(one)) break;
    TRY_INIT(auto state, read_tournament(one));

    const auto& matches = state.matches;
    const bool done = !matches.empty() && all_have_outcomes(matches);
    if (!done || !next_round(tuning.config(), race, matches).empty()) break;
    tuning.record(race_results(tuning.config(), race, matches));
  }
  return {};
}

}  // namespace cls::tournament
