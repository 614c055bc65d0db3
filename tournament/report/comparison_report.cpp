// Texts and members of a comparison; every figure is that of NEW against BASE.
#include "tournament/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/wrap_text.h"
#include "league/rating/statistics.h"
#include "match/terms/match_options.h"
#include "tournament/report/report_model.h"
#include "tournament/report/report_tables.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

using base::Json;

struct Names {
  std::string candidate;
  std::string base;
  bool direct = true;  // NEW plays BASE
};

Names names_of(const Comparison& comparison) {
  const auto& teams = comparison.config.competition.teams;
  return {teams[0].name, teams[1].name, teams.size() == 2};
}

std::string decision_text(const Comparison& comparison, const Names& names,
                          const ComparisonVerdict& verdict) {
  if (verdict.decision == Decision::kOpen) return "undecided";
  const bool better = verdict.decision == Decision::kH1;
  const std::string who =
      fmt::format("{} is {}better than {}", names.candidate, better ? "" : "not ", names.base);
  if (comparison.test.kind == TestKind::kSprt) {
    return fmt::format("{} ({} accepted)", who, name(verdict.decision));
  }
  return fmt::format(
      "{} ({} than {})", who, better ? "by more" : "by less",
      advantage_text(comparison, better ? verdict.hypotheses.mean0 : verdict.hypotheses.mean1));
}

std::string strength_text(const Names& names, const ComparisonVerdict& verdict) {
  const Estimate& strength = verdict.strength;
  if (names.direct) {
    return fmt::format(
        "{} against {}: {} Elo (95 %: {} to {}), score {:.1f} % ({:.1f} to {:.1f}), "
        "likelihood of superiority {:.1f} %",
        names.candidate, names.base, difference_text(strength.elo, 1),
        difference_text(strength.elo_interval.low, 1),
        difference_text(strength.elo_interval.high, 1), 100 * strength.score,
        100 * strength.score_interval.low, 100 * strength.score_interval.high,
        100 * strength.superiority);
  }
  return fmt::format(
      "{} against the same opponents as {}: {} % of the points (95 %: {} to {}), "
      "likelihood of superiority {:.1f} %",
      names.candidate, names.base, difference_text(100 * gain(strength.score), 1),
      difference_text(100 * gain(strength.score_interval.low), 1),
      difference_text(100 * gain(strength.score_interval.high), 1), 100 * strength.superiority);
}

std::string goals_text(const Comparison& comparison, const ComparisonVerdict& verdict) {
  const Estimate goals = estimate(verdict.samples);
  return fmt::format("{} (95 %: {:+.2f} to {:+.2f}), {} up to {}",
                     advantage_text(comparison, goals.score),
                     advantage(comparison, goals.score_interval.low),
                     advantage(comparison, goals.score_interval.high),
                     comparison.test.measure == Measure::kGoals ? "differences" : "values",
                     comparison.test.max_goals);
}

// The evidence of the deciding test.
std::string test_text(const Comparison& comparison, const ComparisonVerdict& verdict) {
  const Hypotheses& h = verdict.hypotheses;
  if (comparison.test.kind == TestKind::kSprt) {
    return fmt::format("LLR {:+.2f} between {:+.2f} and {:+.2f}", verdict.llr, lower_llr(h),
                       upper_llr(h));
  }
  const Interval bounds = verdict.betting.bounds();
  return fmt::format(
      "evidence {:.2f} of {:g} for more than {}, {:.2f} of {:g} for less than {}\n"
      "at every moment: more than {} with {:g} % confidence, less than {} with {:g} %",
      verdict.betting.for_h1(), 1 / h.alpha, advantage_text(comparison, h.mean0),
      verdict.betting.for_h0(), 1 / h.beta, advantage_text(comparison, h.mean1),
      advantage_text(comparison, bounds.low), 100 * (1 - h.alpha),
      advantage_text(comparison, bounds.high), 100 * (1 - h.beta));
}

// Counts by outcome; of values, whose outcomes are many, those that occurred with their counts.
Json samples_json(const Comparison& comparison, const ComparisonVerdict& verdict) {
  if (comparison.test.measure != Measure::kValue) return verdict.samples;
  Json list = Json::array();
  const auto last = static_cast<double>(verdict.samples.size() - 1);
  for (std::size_t i = 0; i < verdict.samples.size(); ++i) {
    if (verdict.samples[i] == 0) continue;
    const double value = advantage(comparison, static_cast<double>(i) / last);
    list.push_back({rounded(value), verdict.samples[i]});
  }
  return list;
}

// "2 x 4 x 100 cycles": matches, situations of each.
std::string situations_text(const Comparison& comparison) {
  const match::MatchOptions options = match_options(comparison.config.conditions);
  return fmt::format("{} x {} situations of {} cycles", matches_in_sample(comparison),
                     options.situations, match::situation_cycles(options));
}

// Only where the unit is goals; the points have members of their own.
void add_goals(Json& document, const Comparison& comparison, const ComparisonVerdict& verdict) {
  const Estimate goals = estimate(verdict.samples);
  const TestSettings& test = comparison.test;
  document["goals0"] = test.goals0;
  document["goals1"] = test.goals1;
  document["max_goals"] = test.max_goals;
  document["points"] = verdict.points;
  document["goal_difference"] = rounded(advantage(comparison, goals.score));
  document["goal_difference_interval"] = {
      rounded(advantage(comparison, goals.score_interval.low)),
      rounded(advantage(comparison, goals.score_interval.high))};
}

// Names of the members by the measure: bounds that are valid at every moment.
void add_bounds(Json& document, const Comparison& comparison, const ComparisonVerdict& verdict) {
  const Interval bounds = verdict.betting.bounds();
  const auto advantages = [&]() -> Json {
    return {rounded(advantage(comparison, bounds.low)),
            rounded(advantage(comparison, bounds.high))};
  };
  if (in_goals(comparison.test.measure)) {
    document["goal_difference_bounds"] = advantages();
  } else if (is_direct(comparison)) {
    document["score_bounds"] = {rounded(bounds.low), rounded(bounds.high)};
    document["elo_bounds"] = {rounded(elo_from_score(bounds.low)),
                              rounded(elo_from_score(bounds.high))};
  } else {
    document["gain_bounds"] = advantages();
  }
}

}  // namespace

std::string_view verdict_name(const ComparisonVerdict& verdict) {
  constexpr std::string_view kNames[] = {"undecided", "not better", "better"};
  return kNames[base::index(verdict.decision)];
}

std::string comparison_text(const Comparison& comparison, std::span<const ScheduledMatch> matches,
                            std::size_t width) {
  const ComparisonVerdict known = verdict(comparison, matches);
  const Names names = names_of(comparison);
  std::string text = fmt::format("verdict: {}\n", decision_text(comparison, names, known));
  auto out = std::back_inserter(text);

  const double samples = total(known.samples);
  if (samples > 0) fmt::format_to(out, "{}\n", strength_text(names, known));
  if (samples > 0 && in_goals(comparison.test.measure)) {
    fmt::format_to(out, "{}\n", goals_text(comparison, known));
  }

  std::string_view sample = sample_name(comparison);
  if (samples == 1) sample.remove_suffix(1);  // the name is a plural
  fmt::format_to(out, "{} {}", samples, sample);
  if (comparison.test.measure == Measure::kValue) {
    fmt::format_to(out, " of {}", situations_text(comparison));
  } else {
    fmt::format_to(out, ", from worst to best: {}", fmt::join(known.samples, " "));
  }
  if (known.left_out > 0) fmt::format_to(out, "; {} excluded (INVALID matches)", known.left_out);
  text += "\n";
  if (samples == 0) return base::wrap_text(text, width);

  fmt::format_to(out, "{}\n{}\n", test_text(comparison, known), known.model);
  if (known.decision != Decision::kOpen) {
    text += "a test that stops early slightly overstates the difference; the verdict is valid\n";
  }
  return base::wrap_text(text, width);
}

std::string comparison_json(const Comparison& comparison, std::span<const ScheduledMatch> matches,
                            std::size_t alike) {
  const ComparisonVerdict known = verdict(comparison, matches);
  const Names names = names_of(comparison);
  const Estimate& strength = known.strength;
  const MatchCounts counts = count(matches);

  Json rows = Json::array();
  for (const ScheduledMatch& match : matches) {
    if (match.outcome) rows.push_back(json_of(comparison.config, match));
  }

  Json document = {{"schema", "cls.compare/1"},
                   {"new", names.candidate},
                   {"base", names.base},
                   {"verdict", verdict_name(known)},
                   {"answer", name(known.decision)},
                   {"test", comparison.test.kind == TestKind::kBetting ? "betting" : "sprt"},
                   {"measure", name(comparison.test.measure)},
                   {"pairs", total(known.samples)},
                   {"evidence",
                    {{"better", rounded(known.betting.for_h1())},
                     {"better_at", rounded(1 / known.hypotheses.alpha)},
                     {"not_better", rounded(known.betting.for_h0())},
                     {"not_better_at", rounded(1 / known.hypotheses.beta)}}},
                   {"llr", rounded(known.llr)},
                   {"lower", rounded(lower_llr(known.hypotheses))},
                   {"upper", rounded(upper_llr(known.hypotheses))},
                   {"elo0", comparison.test.elo0},
                   {"elo1", comparison.test.elo1},
                   {"alpha", comparison.test.alpha},
                   {"beta", comparison.test.beta},
                   {"model", known.model},
                   {"samples", samples_json(comparison, known)},
                   {"left_out", known.left_out},
                   {"alike", alike},
                   {"superiority", rounded(strength.superiority)}};

  if (names.direct) {
    document["score"] = rounded(strength.score);
    document["score_interval"] = {rounded(strength.score_interval.low),
                                  rounded(strength.score_interval.high)};
    document["elo"] = rounded(strength.elo);
    document["elo_interval"] = {rounded(strength.elo_interval.low),
                                rounded(strength.elo_interval.high)};
  } else {
    document["gain"] = rounded(gain(strength.score));
    document["gain_interval"] = {rounded(gain(strength.score_interval.low)),
                                 rounded(gain(strength.score_interval.high))};
  }

  if (in_goals(comparison.test.measure)) add_goals(document, comparison, known);
  add_bounds(document, comparison, known);
  document["counts"] = {{"finished", counts.finished}, {"invalid", counts.invalid}};
  document["matches"] = std::move(rows);
  document["versions"] = {{"cls", base::kVersion}, {"wire", base::kWireVersion}};
  return base::json_document(document);
}

}  // namespace cls::tournament
