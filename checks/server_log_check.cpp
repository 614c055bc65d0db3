// Checks and reports of a replayed match.
#include "checks/server_log_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::checks {
namespace {

using base::Json;
using simulator::ClassTally;
using simulator::Excuse;
using simulator::KickNoise;
using simulator::LogAgreement;
using simulator::Miss;
using simulator::NoiseSample;
using simulator::StepClass;
using simulator::Tally;

// Allowed deviation of a mean in standard deviations, plus rounding.
constexpr double kSigmas = 4.0;
constexpr double kRounding = 0.005;
// Minimum number of samples.
constexpr std::size_t kFewest = 300;
constexpr std::size_t kShown = 10;

LogCheck at_least(std::string what, const Tally& tally, double bound) {
  return {std::move(what), fmt::format("{:.6f}", tally.share()), fmt::format(">= {}", bound),
          tally.share() >= bound};
}

LogCheck at_most(std::string what, double value, double bound) {
  return {std::move(what), fmt::format("{:.4f}", value), fmt::format("<= {:.4f}", bound),
          value <= bound};
}

LogCheck near(std::string what, double value, double aim, double margin) {
  return {std::move(what), fmt::format("{:.4f}", value), fmt::format("{} +- {:.4f}", aim, margin),
          std::fabs(value - aim) <= margin};
}

void check_uniform(const char* object, const NoiseSample& sample, std::vector<LogCheck>& out) {
  if (sample.shares.size() < kFewest) return;
  const double root = std::sqrt(static_cast<double>(sample.shares.size()));
  out.push_back(near(fmt::format("noise of {}: mean", object), sample.mean(), 0.5,
                     kSigmas * std::sqrt(1.0 / 12.0) / root + kRounding));
  // Exceeded by chance once in 10000 logs.
  out.push_back(at_most(fmt::format("noise of {}: distance to uniform", object),
                        sample.distance_to_uniform(), 2.2 / root + kRounding));
}

void check_kick_noise(const KickNoise& kicks, std::vector<LogCheck>& out) {
  if (kicks.n < static_cast<int>(kFewest)) return;
  // The variance of the square of a uniform length is 0.8 times its mean squared.
  out.push_back(near("noise of kicks: variance", kicks.mean(), 1.0,
                     kSigmas * std::sqrt(0.8 / kicks.n) + 4.0 * kRounding));
}

struct GameTally {
  const char* name;
  const Tally& tally;
};

std::vector<GameTally> game_tallies(const LogAgreement& agreement) {
  return {{"mode", agreement.mode},         {"clock", agreement.clock}, {"score", agreement.score},
          {"counters", agreement.counters}, {"state", agreement.state}, {"words", agreement.calls}};
}

std::string object_name(const Miss& miss) {
  if (miss.slot == simulator::kNoPlayer) return "ball";
  return fmt::format("{}{}", soccer::letter(soccer::side_of_slot(miss.slot)),
                     soccer::unum_of_slot(miss.slot));
}

Json to_json(const Tally& tally) { return {{"steps", tally.steps}, {"agreed", tally.agreed}}; }

Json to_json(const NoiseSample& sample) {
  return {{"n", sample.shares.size()},
          {"mean", sample.mean()},
          {"largest", sample.largest()},
          {"distance_to_uniform", sample.distance_to_uniform()}};
}

Json misses_json(const LogAgreement& agreement) {
  Json misses = Json::array();
  for (const Miss& miss : agreement.misses) {
    misses.push_back({{"cycle", miss.clock.time},
                      {"stopped", miss.clock.stoppage},
                      {"object", object_name(miss)},
                      {"class", simulator::name(miss.step_class)},
                      {"what", miss.what}});
  }
  return misses;
}

void add_list(std::string& text, const char* title, const std::vector<std::string>& list) {
  if (list.empty()) return;
  text += fmt::format("\n{}:\n", title);
  for (std::size_t i = 0; i < std::min(list.size(), kShown); ++i) {
    text += fmt::format("  {}\n", list[i]);
  }
  if (list.size() > kShown) text += fmt::format("  and {} more\n", list.size() - kShown);
}

void add_classes(const LogAgreement& agreement, std::string& text) {
  text += fmt::format("\n{:18} {:>8} {:>8} {:>7} {:>11}\n", "class of step", "steps", "agreed",
                      "misses", "worst");
  const auto row = [&](std::string_view name, const Tally& tally, const std::string& worst) {
    text += fmt::format("{:18} {:8} {:8} {:7} {:>11}\n", name, tally.steps, tally.agreed,
                        tally.misses(), worst);
  };

  for (std::size_t i = 0; i < simulator::kStepClassCount; ++i) {
    const ClassTally& tally = agreement.by_class[i];
    if (tally.steps == 0) continue;
    row(simulator::name(static_cast<StepClass>(i)), tally, fmt::format("{:.6f}", tally.worst));
  }

  text += "\n";
  row("ball", agreement.ball, "");
  row("players", agreement.players, "");
  for (const GameTally& game : game_tallies(agreement)) row(game.name, game.tally, "");
}

std::vector<std::string> miss_lines(const LogAgreement& agreement) {
  std::vector<std::string> lines;
  for (const Miss& miss : agreement.misses) {
    lines.push_back(fmt::format("{},{} {} {}: {}", miss.clock.time, miss.clock.stoppage,
                                object_name(miss), simulator::name(miss.step_class), miss.what));
  }
  return lines;
}

}  // namespace

std::vector<LogCheck> log_checks(const LogAgreement& agreement) {
  std::vector<LogCheck> out;
  out.push_back(at_least("ball", agreement.ball, 0.999));
  out.push_back(at_least("players", agreement.players, 0.999));

  for (std::size_t i = 0; i < simulator::kStepClassCount; ++i) {
    const ClassTally& tally = agreement.by_class[i];
    const int most = std::max(1, tally.steps / 1000);
    if (tally.misses() <= most) continue;
    out.push_back({fmt::format("misses of {}", simulator::name(static_cast<StepClass>(i))),
                   std::to_string(tally.misses()), fmt::format("<= {}", most), false});
  }

  // Which of two contacts in a cycle is stronger may depend on noise, which no log records.
  const double game = agreement.has_noise ? 0.999 : 1.0;
  out.push_back(at_least("mode", agreement.mode, game));
  out.push_back(at_least("clock", agreement.clock, game));
  out.push_back(at_least("score", agreement.score, game));
  out.push_back(at_least("counters", agreement.counters, 1.0));
  out.push_back(at_least("state bits", agreement.state, 0.9999));

  if (!agreement.has_noise) out.push_back(at_most("excused", agreement.excused_share(), 0.005));
  check_uniform("players", agreement.player_noise, out);
  check_uniform("the ball", agreement.ball_noise, out);
  check_kick_noise(agreement.kick_noise, out);
  return out;
}

bool passed(const std::vector<LogCheck>& log_checks) {
  return std::ranges::all_of(log_checks, [](const LogCheck& d) { return d.passed; });
}

std::string to_text(const LogAgreement& agreement, const std::vector<LogCheck>& log_checks) {
  std::string text =
      fmt::format("{} steps of {} frames{}: {:.4f} % agree, {:.4f} % excused\n", agreement.steps(),
                  agreement.frames, agreement.has_noise ? ", with noise" : ", without noise",
                  100.0 * agreement.agreement(), 100.0 * agreement.excused_share());

  if (agreement.skipped > 0) {
    text += fmt::format("{} pairs of frames skipped: frames or text log missing between them\n",
                        agreement.skipped);
  }

  add_classes(agreement, text);
  std::string causes;
  for (std::size_t i = 0; i < simulator::kExcuseCount; ++i) {
    if (agreement.by_cause[i] == 0) continue;
    causes += fmt::format("{}{} {}", causes.empty() ? "" : ", ",
                          simulator::name(static_cast<Excuse>(i)), agreement.by_cause[i]);
  }
  if (!causes.empty()) text += fmt::format("\nexcused: {}\n", causes);

  add_list(text, "first misses (cycle,stopped)", miss_lines(agreement));
  add_list(text, "different course of the game", agreement.game_misses);
  add_list(text, "called only in the log", agreement.missing_calls);
  add_list(text, "called only by the simulator", agreement.extra_calls);

  text += "\n";
  for (const LogCheck& demand : log_checks) {
    text += fmt::format("{} {:35} {:>10}  {}\n", demand.passed ? "pass" : "FAIL", demand.what,
                        demand.reached, demand.bound);
  }
  return text;
}

std::string to_json(const LogAgreement& agreement, const std::vector<LogCheck>& log_checks) {
  Json document = {{"schema", "cls.server-log/1"},
                   {"passed", passed(log_checks)},
                   {"agreement", agreement.agreement()},
                   {"steps", agreement.steps()},
                   {"agreed", agreement.agreed()},
                   {"excused", agreement.excused},
                   {"excused_share", agreement.excused_share()},
                   {"uncounted", agreement.uncounted},
                   {"has_noise", agreement.has_noise},
                   {"frames", agreement.frames},
                   {"skipped", agreement.skipped},
                   {"ball", to_json(agreement.ball)},
                   {"players", to_json(agreement.players)}};

  Json& classes = document["by_class"] = Json::object();
  for (std::size_t i = 0; i < simulator::kStepClassCount; ++i) {
    const ClassTally& tally = agreement.by_class[i];
    if (tally.steps == 0) continue;
    Json& entry = classes[std::string(simulator::name(static_cast<StepClass>(i)))];
    entry = to_json(static_cast<const Tally&>(tally));
    entry["worst"] = tally.worst;
  }

  Json& causes = document["by_cause"] = Json::object();
  for (std::size_t i = 0; i < simulator::kExcuseCount; ++i) {
    if (agreement.by_cause[i] == 0) continue;
    causes[std::string(simulator::name(static_cast<Excuse>(i)))] = agreement.by_cause[i];
  }
  for (const GameTally& game : game_tallies(agreement)) document[game.name] = to_json(game.tally);

  if (agreement.has_noise) {
    document["noise"] = {
        {"players", to_json(agreement.player_noise)},
        {"ball", to_json(agreement.ball_noise)},
        {"kicks", {{"n", agreement.kick_noise.n}, {"variance", agreement.kick_noise.mean()}}}};
  }

  document["misses"] = misses_json(agreement);
  document["game_misses"] = agreement.game_misses;
  document["missing_words"] = agreement.missing_calls;
  document["added_words"] = agreement.extra_calls;

  Json& list = document["demands"] = Json::array();
  for (const LogCheck& demand : log_checks) {
    list.push_back({{"what", demand.what},
                    {"reached", demand.reached},
                    {"bound", demand.bound},
                    {"passed", demand.passed}});
  }
  return base::json_document(document);
}

}  // namespace cls::checks
