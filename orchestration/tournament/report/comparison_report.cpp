// Texts and members of a comparison; every figure is that of NEW against BASE.
#include "orchestration/tournament/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/system/version.h"
#include "base/text/json_text.h"
#include "base/text/wrap_text.h"
#include "orchestration/tournament/report/report_model.h"
#include "orchestration/tournament/report/report_tables.h"
#include "orchestration/tournament/store/match_document.h"

namespace cls::orchestration::tournament {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

struct Names {
  std::string candidate;
  std::string base;
  bool direct = true;  // NEW plays BASE
};

Names names_of(const Comparison& comparison) {
  const auto& teams = comparison.config.teams;
  return {teams[0].name, teams[1].name, teams.size() == 2};
}

std::string decision_text(const Names& names, const ComparisonVerdict& verdict) {
  switch (verdict.state.decision) {
    case SprtDecision::kH1:
      return fmt::format("{} is better than {} (H1 accepted)", names.candidate, names.base);
    case SprtDecision::kH0:
      return fmt::format("{} is not better than {} (H0 accepted)", names.candidate, names.base);
    case SprtDecision::kOpen:
      return "undecided";
  }
  return {};
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

}  // namespace

std::string_view verdict_name(const ComparisonVerdict& verdict) {
  switch (verdict.state.decision) {
    case SprtDecision::kH1:
      return "better";
    case SprtDecision::kH0:
      return "not better";
    case SprtDecision::kOpen:
      return "undecided";
  }
  return "";
}

std::string comparison_text(const Comparison& comparison, std::span<const ScheduledMatch> matches,
                            std::size_t width) {
  const ComparisonVerdict known = verdict(comparison, matches);
  const Names names = names_of(comparison);
  std::string text = fmt::format("verdict: {}\n", decision_text(names, known));
  auto out = std::back_inserter(text);
  fmt::format_to(out, "{}\n", strength_text(names, known));
  fmt::format_to(out, "{} {}, from worst to best: {}", total(known.samples),
                 sample_name(comparison), fmt::join(known.samples, " "));
  if (known.left_out > 0) fmt::format_to(out, "; {} excluded (INVALID matches)", known.left_out);
  fmt::format_to(out, "\nLLR {:+.2f} between {:+.2f} and {:+.2f}\n{}\n", known.state.llr,
                 comparison.sprt.lower(), comparison.sprt.upper(), known.model);
  if (known.state.decision != SprtDecision::kOpen) {
    text += "a test that stops early slightly overstates the difference; the verdict is valid\n";
  }
  return base::wrap_text(text, width);
}

std::string comparison_json(const Comparison& comparison, std::span<const ScheduledMatch> matches) {
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
                   {"answer", name(known.state.decision)},
                   {"llr", rounded(known.state.llr)},
                   {"lower", rounded(comparison.sprt.lower())},
                   {"upper", rounded(comparison.sprt.upper())},
                   {"elo0", comparison.sprt.elo0},
                   {"elo1", comparison.sprt.elo1},
                   {"alpha", comparison.sprt.alpha},
                   {"beta", comparison.sprt.beta},
                   {"model", known.model},
                   {"samples", known.samples},
                   {"left_out", known.left_out},
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
  document["counts"] = {{"finished", counts.finished}, {"invalid", counts.invalid}};
  document["matches"] = std::move(rows);
  document["versions"] = {{"cls", base::kVersion}, {"wire", base::kWireVersion}};
  return base::json_document(document);
}

}  // namespace cls::orchestration::tournament
