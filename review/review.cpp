// A review as text and JSON.
#include "review/review.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/system/version.h"
#include "base/text/counted.h"
#include "base/text/table.h"

namespace cls::review {
namespace {

using base::Json;
using base::Table;

// Without "-0.00".
std::string decimals(double value) {
  return fmt::format("{:.2f}", std::abs(value) < 0.005 ? 0.0 : value);
}

std::string signed_text(const Estimate& estimate) {
  return fmt::format("{} to {}", decimals(estimate.low), decimals(estimate.high));
}

int goals_of(const Review& review, int ReviewedMatch::*goals) {
  int sum = 0;
  for (const ReviewedMatch& match : review.matches) sum += match.*goals;
  return sum;
}

std::vector<std::vector<Chance>> chances_of(const Review& review,
                                            std::vector<Chance> Chances::*chances) {
  std::vector<std::vector<Chance>> all;
  for (const ReviewedMatch& match : review.matches) all.push_back(match.chances.*chances);
  return all;
}

std::vector<LossClass> loss_classes(const Review& review) {
  std::vector<std::vector<Loss>> losses;
  for (const ReviewedMatch& match : review.matches) losses.push_back(match.losses);
  return classes_of(losses);
}

Json estimate_json(const Estimate& estimate) {
  return {{"value", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

Json reference_json(const Reference& reference) {
  Json differences = Json::array();
  for (const Difference& one : reference.differences) {
    differences.push_back({{"statistic", one.statistic},
                           {"unit", one.unit},
                           {"team", one.team},
                           {"reference", one.reference},
                           {"difference", estimate_json(one.difference)}});
  }
  return {{"team", reference.team},
          {"matches", reference.matches},
          {"differences", std::move(differences)}};
}

Json chances_json(const std::vector<Chance>& chances) {
  Json list = Json::array();
  for (const Chance& chance : chances) {
    list.push_back({{"cycle", chance.cycle},
                    {"worth", chance.worth},
                    {"origin", chance.origin},
                    {"finish", chance.finish}});
  }
  return list;
}

Json losses_json(const Review& review) {
  Json list = Json::array();
  for (const LossClass& one : loss_classes(review)) {
    list.push_back({{"name", one.name},
                    {"decisions", one.decisions},
                    {"goals", estimate_json(one.goals)},
                    {"match", one.worst.match},
                    {"cycle", one.worst.cycle}});
  }
  return list;
}

Json worths_json(const Worths& worths) {
  Json list = Json::array();
  for (const double worth : worths) list.push_back(worth);
  return list;
}

Json decision_json(const Verdict& verdict) {
  const PlayedDecision& played = verdict.played;
  const Decision& decision = played.decision;

  Json alternatives = Json::array();
  for (std::size_t i = 0; i < played.alternatives.size(); ++i) {
    const Alternative& alternative = played.alternatives[i];
    alternatives.push_back({{"decision", alternative.text},
                            {"kind", alternative.group},
                            {"planner", alternative.planned},
                            {"target", {alternative.target.x, alternative.target.y}},
                            {"worths", worths_json(played.worths[i])}});
  }

  const Alternative* best = verdict.best();
  return {{"match", verdict.match},
          {"cycle", decision.cycle},
          {"unum", soccer::unum_of_slot(decision.slot)},
          {"decision", text_of(decision)},
          {"kind", kDecisionNames.name(decision.kind)},
          {"value_before", decision.before},
          {"value_after", decision.after},
          {"better", best == nullptr ? Json() : Json(best->text)},
          {"cost", estimate_json(verdict.cost)},
          {"worths", worths_json(played.recorded)},
          {"alternatives", alternatives}};
}

std::string place_text(const Review& review, const Place& place) {
  return fmt::format("{} {}", review.matches[place.match].folder, place.cycle);
}

// A table of classes of chances, with a line that names it.
std::string classes_text(const Review& review, const std::string& title,
                         std::vector<Chance> Chances::*chances, std::string Chance::*field,
                         std::size_t most) {
  const std::vector<ChanceClass> classes = classes_of(chances_of(review, chances), field);
  if (classes.empty()) return {};

  Table table;
  table.add_column("goals", Table::Align::kRight);
  table.add_column("times", Table::Align::kRight);
  table.add_column("how");
  table.add_column("seen in, at cycle");
  for (std::size_t i = 0; i < std::min(most, classes.size()); ++i) {
    const ChanceClass& one = classes[i];
    table.add_row({decimals(one.worth), fmt::to_string(one.chances), one.name,
                   place_text(review, one.worst)});
  }
  return fmt::format("\n{}\n{}", title, table.format_text(2));
}

// "12.3 %".
std::string with_unit(double value, const char* unit) {
  return fmt::format("{:.1f}{}{}", value, *unit != '\0' ? " " : "", unit);
}

// The difference that more matches decide first.
std::string nearest_text(const Reference& reference) {
  std::string text = "  no statistic differs beyond doubt in these matches";
  if (reference.differences.empty()) return text + "\n";
  const Difference& one = reference.differences.front();
  return text + fmt::format("; nearest to it: {}, {} against {} ({:+.1f} to {:+.1f})\n",
                            one.statistic, with_unit(one.team, one.unit),
                            with_unit(one.reference, one.unit), one.difference.low,
                            one.difference.high);
}

// The differences beyond doubt.
std::string reference_text(const Reference& reference, std::size_t most) {
  Table table;
  table.add_column("a match", Table::Align::kRight);
  table.add_column("reference", Table::Align::kRight);
  table.add_column("difference", Table::Align::kRight);
  table.add_columns({"95 %", "statistic"});
  std::size_t rows = 0;
  for (const Difference& one : reference.differences) {
    if (!one.certain() || rows == most) continue;
    ++rows;
    table.add_row({with_unit(one.team, one.unit), with_unit(one.reference, one.unit),
                   fmt::format("{:+.1f}", one.difference.value),
                   fmt::format("{:+.1f} to {:+.1f}", one.difference.low, one.difference.high),
                   one.statistic});
  }
  const std::string title = fmt::format("\nfarthest from {} ({})\n", reference.team,
                                        base::counted(reference.matches, "match", "matches"));
  if (rows == 0) return title + nearest_text(reference);
  return title + table.format_text(2);
}

// What all decisions lost, as goals a match.
std::string losses_text(const Review& review, std::size_t most) {
  const std::vector<LossClass> classes = loss_classes(review);
  if (classes.empty()) return {};

  const auto matches = static_cast<double>(review.matches.size());
  Table table;
  table.add_column("goals", Table::Align::kRight);
  table.add_column("95 %");
  table.add_column("times", Table::Align::kRight);
  table.add_columns({"what", "seen in, at cycle"});
  for (std::size_t i = 0; i < std::min(most, classes.size()); ++i) {
    const LossClass& one = classes[i];
    const Estimate a_match = {one.goals.value / matches, one.goals.low / matches,
                              one.goals.high / matches};
    table.add_row({decimals(a_match.value), signed_text(a_match), fmt::to_string(one.decisions),
                   one.name, place_text(review, one.worst)});
  }
  return "\nlost from a decision with the ball to the next one (goals a match)\n" +
         table.format_text(2);
}

std::string decisions_text(const Review& review, std::size_t most) {
  Table table;
  table.add_column("goals", Table::Align::kRight);
  table.add_column("95 %");
  table.add_column("player", Table::Align::kRight);
  table.add_columns({"did", "better", "match, cycle"});
  std::size_t rows = 0;
  for (const Verdict& verdict : review.decisions) {
    const Decision& decision = verdict.played.decision;
    if (!verdict.better || rows == most) break;
    ++rows;
    table.add_row({decimals(verdict.cost.value), signed_text(verdict.cost),
                   fmt::to_string(soccer::unum_of_slot(decision.slot)), text_of(decision),
                   verdict.best()->text, place_text(review, {verdict.match, decision.cycle})});
  }
  if (rows == 0) return "  the playouts prefer no other decision\n";
  return table.format_text(2);
}

std::string groups_text(const Review& review, std::size_t most) {
  Table table;
  table.add_column("goals", Table::Align::kRight);
  table.add_column("95 %");
  table.add_column("times", Table::Align::kRight);
  table.add_columns({"did", "better"});
  const std::vector<VerdictGroup> groups = group(review.decisions);
  for (std::size_t i = 0; i < std::min(most, groups.size()); ++i) {
    table.add_row({decimals(groups[i].cost.value), signed_text(groups[i].cost),
                   fmt::to_string(groups[i].decisions), groups[i].recorded, groups[i].better});
  }
  return groups.empty() ? "" : "\nthe same by kind\n" + table.format_text(2);
}

}  // namespace

Json to_json(const Review& review) {
  Json matches = Json::array();
  for (const ReviewedMatch& match : review.matches) {
    matches.push_back({{"file", match.file},
                       {"side", side_name(match.side)},
                       {"opponent", match.opponent},
                       {"goals", match.goals},
                       {"goals_against", match.goals_against},
                       {"decisions", match.losses.size()},
                       {"against", chances_json(match.chances.against)},
                       {"wasted", chances_json(match.chances.wasted)}});
  }

  Json decisions = Json::array();
  for (const Verdict& decision : review.decisions) {
    decisions.push_back(decision_json(decision));
  }
  Json kinds = Json::array();
  for (const VerdictGroup& one : group(review.decisions)) {
    kinds.push_back({{"kind", one.recorded},
                     {"better", one.better},
                     {"decisions", one.decisions},
                     {"cost", estimate_json(one.cost)}});
  }

  Json skipped = Json::array();
  for (const std::string& why : review.skipped) skipped.push_back(why);
  return {{"schema", kReviewSchema},
          {"version", std::string(base::kVersion)},
          {"team", review.team},
          {"continued_by", review.continued_by},
          {"seeds", review.terms.seeds},
          {"seed", review.terms.seed},
          {"cycles", review.terms.cycles},
          {"interrupted", review.interrupted},
          {"matches", matches},
          {"losses", losses_json(review)},
          {"reference", review.reference ? reference_json(*review.reference) : Json()},
          {"decisions", decisions},
          {"kinds", kinds},
          {"skipped", skipped}};
}

std::string to_text(const Review& review, std::size_t most) {
  const auto count = static_cast<double>(review.matches.size());
  std::string text = fmt::format("{}: {}, {:.2f} : {:.2f} goals a match\n", review.team,
                                 base::counted(review.matches.size(), "match", "matches"),
                                 goals_of(review, &ReviewedMatch::goals) / count,
                                 goals_of(review, &ReviewedMatch::goals_against) / count);

  text += classes_text(review, "goals against, by how the ball was lost", &Chances::against,
                       &Chance::origin, most);
  text +=
      classes_text(review, "goals against, by finish", &Chances::against, &Chance::finish, most);
  text += classes_text(review, "chances wasted, by finish (expected goals)", &Chances::wasted,
                       &Chance::finish, most);
  text += losses_text(review, most);
  if (review.reference) text += reference_text(*review.reference, most);
  if (review.decisions.empty() && review.skipped.empty()) return text;

  text += fmt::format(
      "\ndecisions that cost most: {} of {} cycles after each choice, played by the {}\n",
      base::counted(base::index(review.terms.seeds), "playout"), review.terms.cycles,
      review.continued_by);
  text += decisions_text(review, most) + groups_text(review, most);
  for (const std::string& why : review.skipped) text += fmt::format("not played again: {}\n", why);
  return text;
}

}  // namespace cls::review
