// Chooses decisions, plays them in parallel, and saves each verdict.
#include "cli/logs/review_replays.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "base/io/whole_file.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/terminal/log_progress.h"
#include "review/moment.h"
#include "review/scenarios.h"

namespace cls::cli {

namespace fs = std::filesystem;

int Replays::continue_saved() {
  if (options_.save.empty()) return kOk;
  const std::optional<std::string> text = base::read_file(options_.save);
  if (!text) return kOk;

  auto saved = review::SavedDecisions::read(base::Json::parse_or_discarded(*text), review_);
  if (!saved) {
    return print_error(kUsage, "--save {}: {}; remove it, or name another file", options_.save,
                       saved.error().message);
  }
  saved_ = *std::move(saved);
  return kOk;
}

void Replays::add(const LoadedMatch& loaded, analysis::MatchStatistics statistics,
                  soccer::Side side) {
  std::vector<review::Decision> all = review::find_decisions(statistics, side);
  review_.matches.back().losses = review::losses_of(statistics, all, side);
  std::erase_if(all, [&](const review::Decision& one) {
    return !review::has_warm_up(statistics.flow, one.frame);
  });

  const std::size_t match = matches_.size();
  std::set<std::size_t> saved_frames;
  for (const review::Decision& one : all) {
    auto saved = saved_.find(loaded.logs.game, one);
    if (!saved) continue;
    saved_frames.insert(one.frame);
    candidates_.push_back({match, one, review::judge(*std::move(saved), match), {}});
  }
  for (const review::Decision& one : review::costliest(std::move(all), options_.decisions)) {
    if (!saved_frames.contains(one.frame)) candidates_.push_back({match, one, {}, {}});
  }

  PlayedMatch& played = matches_.emplace_back();
  played.loaded = &loaded;
  played.flow = std::move(statistics.flow);
}

int Replays::play() {
  std::set<std::string> other = saved_.files();
  for (const review::ReviewedMatch& match : review_.matches) other.erase(match.file);
  if (!other.empty()) {
    return print_error(kUsage,
                       "--save {}: has decisions of {}; review that, too, or name another file",
                       options_.save, *other.begin());
  }

  choose();
  prepare_matches();
  std::vector<Candidate*> open;
  for (Candidate& one : candidates_) {
    if (!one.verdict) open.push_back(&one);
  }

  LogProgress progress(open.size(), "decisions");
  base::parallel_for(
      open.size(), options_.jobs, [&](std::size_t i) { play(*open[i]); },
      [&](std::size_t count) { progress.update(count); });
  if (!open.empty()) save();
  assemble();
  return save_error_.empty() ? kOk : print_error(kCannotCreate, "{}", save_error_);
}

int Replays::write_scenarios(const std::string& folder) const {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return print_error(kCannotCreate, "--scenarios {}: {}", folder, code.message());

  const auto endpoint = endpoint_of_team(review_.team, fs::absolute(folder));
  const bool in_project = endpoint && *endpoint != review_.team;
  const std::string playmaker = in_project ? review_.team : "mock:planner";
  for (const review::Verdict& verdict : review_.decisions) {
    if (!verdict.better) continue;
    const review::Decision& decision = verdict.played.decision;
    const std::string& match = review_.matches[verdict.match].folder;
    const fs::path file =
        fs::path(folder) / fmt::format("{}-{}-player-{}.json", fs::path(match).filename().string(),
                                       decision.cycle, soccer::unum_of_slot(decision.slot));
    const review::ScenarioTerms terms = {match, playmaker, review_.terms.cycles};
    const std::string text =
        review::scenario_of(matches_[verdict.match].loaded->record, verdict, terms).dump(2) + "\n";

    const std::optional<std::string> there = base::read_file(file);
    if (there && *there != text) {
      return print_error(kCannotCreate,
                         "{}: is there and differs; remove it, or name another folder",
                         file.string());
    }
    const auto written = base::write_file(file, text);
    if (!written) return print_error(kCannotCreate, "{}", written.error().message);
  }
  return kOk;
}

// The costliest of all matches, and all that were saved.
void Replays::choose() {
  std::ranges::stable_sort(candidates_, std::ranges::greater{},
                           [](const Candidate& one) { return one.decision.lost(); });
  std::size_t place = 0;
  std::erase_if(candidates_,
                [&](const Candidate& one) { return ++place > options_.decisions && !one.verdict; });
}

// Reads the text logs of those matches that have decisions to play.
void Replays::prepare_matches() {
  std::set<std::size_t> wanted;
  for (const Candidate& one : candidates_) {
    if (!one.verdict) wanted.insert(one.match);
  }
  const std::vector<std::size_t> list(wanted.begin(), wanted.end());
  base::parallel_for(list.size(), options_.jobs,
                     [&](std::size_t i) { prepare(matches_[list[i]]); });
}

void Replays::prepare(PlayedMatch& match) const {
  const gamelog::MatchRecord& record = match.loaded->record;
  match.problem = review::why_not_played(record);
  if (!match.problem.empty()) return;
  if (match.loaded->logs.text.empty()) {
    match.problem = "the text log (rcl) is missing";
    return;
  }

  const training::Driver driver = *training::kDriverNames.parse(options_.continued_by);
  auto text = gamelog::read_rcl_file(match.loaded->logs.text);
  auto setup = review::setup_of(record, {driver, driver});
  if (!text || !setup) {
    match.problem = !text ? text.error().message : setup.error().message;
    return;
  }
  match.text = *std::move(text);
  match.sent.emplace(match.text, record.final_teams());
  match.setup = *std::move(setup);
}

void Replays::play(Candidate& candidate) {
  if (watch_interrupts() != 0) return;
  const PlayedMatch& match = matches_[candidate.match];
  base::Result<review::PlayedDecision> played = base::Error{match.problem};
  if (match.problem.empty()) {
    played =
        review::play_again(match.setup, match.flow, *match.sent, candidate.decision, review_.terms);
  }

  const std::lock_guard lock(mutex_);
  if (!played) {
    candidate.problem = played.error().message;
    return;
  }
  candidate.verdict = review::judge(*std::move(played), candidate.match);
  save();
}

// The review has what is done so far.
void Replays::assemble() {
  review_.decisions.clear();
  review_.skipped.clear();
  review_.interrupted = false;
  for (const Candidate& one : candidates_) {
    if (one.verdict) {
      review_.decisions.push_back(*one.verdict);
    } else if (one.problem.empty()) {
      review_.interrupted = true;
    } else {
      review_.skipped.push_back(fmt::format("{} {}: {}", review_.matches[one.match].folder,
                                            one.decision.cycle, one.problem));
    }
  }
  std::ranges::stable_sort(
      review_.decisions, std::ranges::greater{},
      [](const review::Verdict& one) { return one.better ? one.cost.value : -1e9; });
}

// After each decision, so that a killed command loses none.
void Replays::save() {
  if (options_.save.empty() || !save_error_.empty()) return;
  assemble();
  const auto written = base::write_file(options_.save, to_json(review_).dump(1) + "\n");
  if (!written) save_error_ = written.error().message;
}

}  // namespace cls::cli
