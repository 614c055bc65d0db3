// Tables, documents and charts of a tuning.
#include "tournament/tuning/tune_report.h"

#include <fmt/format.h>

#include <iterator>

#include "base/system/version.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "base/text/table.h"
#include "base/text/wrap_text.h"
#include "league/rating/statistics.h"
#include "tournament/tuning/candidate.h"
#include "viewer/charts/charts.h"
#include "viewer/charts/drawing.h"

namespace cls::tournament {
namespace {

using base::Json;

std::string_view method_name(const TuneConfig& config) {
  return config.method == TuneMethod::kCmaEs ? "cma-es" : "spsa";
}

Values start_values(const TuneConfig& config) {
  return values_at(config.parameters, start_point(config.parameters));
}

double number(const Parameter& parameter, double value) {
  return base::parse_number(value_text(parameter, value)).value();
}

Json json_of(const TuneConfig& config, const Values& values) {
  Json document = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) {
    document[config.parameters[i].name] = number(config.parameters[i], values[i]);
  }
  return document;
}

Json json_of(const TuneConfig& config, const Generation& generation) {
  Json candidates = Json::array();
  for (std::size_t i = 0; i < generation.candidates.size(); ++i) {
    const RaceResult& result = generation.results[i];
    candidates.push_back({{"values", json_of(config, generation.candidates[i])},
                          {"pairs", result.pairs.size()},
                          {"score", rounded(measured(config, result.mean()))},
                          {"stopped", result.stopped}});
  }
  const Estimate& score = generation.score;
  return {{"score", rounded(measured(config, score.score))},
          {"score_interval",
           {rounded(measured(config, score.score_interval.low)),
            rounded(measured(config, score.score_interval.high))}},
          {"best", json_of(config, generation.best)},
          {"candidates", std::move(candidates)}};
}

std::string parameter_table(const Tuning& tuning, std::size_t width) {
  const TuneConfig& config = tuning.config();
  const Values start = start_values(config);
  const Values best = tuning.best();
  const auto spread = tuning.spread();

  base::Table table;
  table.add_column("parameter");
  table.add_columns({"start", "best"}, base::Table::Align::kRight);
  table.add_columns({"spread", "range"});
  for (std::size_t i = 0; i < best.size(); ++i) {
    const Parameter& one = config.parameters[i];
    table.add_row(
        {one.name, value_text(one, start[i]), value_text(one, best[i]),
         fmt::format("{} to {}", value_text(one, spread[i].low), value_text(one, spread[i].high)),
         fmt::format("{} to {}{}", value_text(one, one.min), value_text(one, one.max),
                     one.scale == Scale::kLog ? ", log" : "")});
  }
  return table.format_text({0, width, 1});
}

viewer::SearchData::Value band(const TuneConfig& config, const Estimate& score) {
  return {measured(config, score.score), measured(config, score.score_interval.low),
          measured(config, score.score_interval.high)};
}

}  // namespace

std::string score_text(const TuneConfig& config, const Estimate& score) {
  const viewer::SearchData::Value value = band(config, score);
  if (in_goals(config.measure)) {
    return fmt::format("{:+.2f} goals a match ({:+.2f} to {:+.2f})", value.center, value.low,
                       value.high);
  }
  return fmt::format("{:.1f} % of the points ({:.1f} to {:.1f})", 100 * value.center,
                     100 * value.low, 100 * value.high);
}

std::string generation_line(const Tuning& tuning) {
  const TuneConfig& config = tuning.config();
  const Generation& last = tuning.history().back();
  std::string line = fmt::format("generation {}/{}: {}", tuning.history().size(),
                                 config.generations, score_text(config, last.score));
  for (std::size_t i = 0; i < last.best.size(); ++i) {
    line += fmt::format("  {} {}", config.parameters[i].name,
                        value_text(config.parameters[i], last.best[i]));
  }
  return line;
}

std::string values_diff(const TuneConfig& config, const Values& before, const Values& after) {
  std::string text;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Parameter& one = config.parameters[i];
    const std::string old_text = value_text(one, before[i]);
    const std::string new_text = value_text(one, after[i]);
    if (old_text == new_text) continue;
    text += fmt::format("-{0} = {1}\n+{0} = {2}\n", one.name, old_text, new_text);
  }
  return text;
}

std::string tune_text(const Tuning& tuning, const std::optional<TuneVerdict>& verdict,
                      std::size_t width) {
  const TuneConfig& config = tuning.config();
  std::string text =
      fmt::format("{}: generation {} of {}, {}\n", method_name(config), tuning.history().size(),
                  config.generations, base::counted(tuning.pairs_played(), "pair"));
  if (!tuning.history().empty()) {
    text += fmt::format("first generation: {}\nlast generation: {}\n",
                        score_text(config, tuning.history().front().score),
                        score_text(config, tuning.history().back().score));
  }

  text = base::wrap_text(text, width) + "\n" + parameter_table(tuning, width);
  const std::string diff = values_diff(config, start_values(config), tuning.best());
  text += diff.empty() ? "\nno value changed\n" : "\n--- start\n+++ best\n" + diff;
  if (verdict)
    text += "\nbest against start, on seeds that the search did not use:\n" + verdict->text;
  return text;
}

std::string tune_json(const Tuning& tuning, const std::optional<TuneVerdict>& verdict) {
  const TuneConfig& config = tuning.config();
  Json generations = Json::array();
  for (const Generation& one : tuning.history()) generations.push_back(json_of(config, one));
  const Json document = {{"schema", "cls.tune/1"},
                         {"method", method_name(config)},
                         {"measure", name(config.measure)},
                         {"generations", config.generations},
                         {"played", tuning.history().size()},
                         {"pairs", tuning.pairs_played()},
                         {"start", json_of(config, start_values(config))},
                         {"best", json_of(config, tuning.best())},
                         {"verdict", verdict ? Json(verdict->verdict) : Json()},
                         {"history", std::move(generations)},
                         {"versions", {{"cls", base::kVersion}, {"wire", base::kWireVersion}}}};
  return base::json_document(document);
}

std::string tune_picture(const Tuning& tuning) {
  const TuneConfig& config = tuning.config();
  viewer::SearchData data;
  data.title = {fmt::format("{} over {}", method_name(config),
                            base::counted(tuning.history().size(), "generation")),
                base::counted(tuning.pairs_played(), "pair")};

  const bool goals = in_goals(config.measure);
  data.unit = goals ? "goals a match" : "share of the points";
  data.even = goals ? 0.0 : 0.5;
  for (const Generation& one : tuning.history()) data.scores.push_back(band(config, one.score));

  const Point start = start_point(config.parameters);
  for (std::size_t i = 0; i < config.parameters.size(); ++i) {
    const Parameter& parameter = config.parameters[i];
    viewer::SearchData::Trace trace;
    trace.name = parameter.name;
    trace.ends = {value_text(parameter, parameter.min), value_text(parameter, parameter.max)};
    trace.values.push_back({start[i], start[i] - parameter.step, start[i] + parameter.step});

    for (const Generation& one : tuning.history()) {
      const double center = one.coordinates[i];
      trace.values.push_back({center, center - one.spread[i], center + one.spread[i]});
    }
    data.traces.push_back(std::move(trace));
  }
  return viewer::standalone_svg(viewer::search_chart(data));
}

}  // namespace cls::tournament
