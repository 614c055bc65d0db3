// Situations in a running match, and their values.
#include "match/hooks/situation_run.h"

#include <cmath>
#include <utility>

#include "analysis/situations/situation_value.h"
#include "base/index.h"
#include "simulator/sessions/match_recorder.h"

namespace cls::match {
namespace {

using simulator::Events;
using simulator::World;

constexpr double kPerOne = 1e6;  // of figures in results

}  // namespace

SituationRun::SituationRun(const analysis::Book& book, std::uint64_t seed, int situations,
                           int cycles)
    : book_(book), play_(book, seed, situations, cycles) {}

void SituationRun::arrange(World& world, Events& events) {
  play_.begin(world, events);
  record_play(world);
}

void SituationRun::after_step(World& world, Events& events) {
  if (play_.over()) return;
  play_.after_step(world);
  record_play(world);
  if (!play_.ended()) return;

  finish();
  play_.next(world, events);
  if (!play_.over()) record_play(world);
}

void SituationRun::record_play(const World& world) {
  if (!play_.in_play()) return;
  if (!builder_) {
    builder_.emplace(record_);
    record_.server = world.rules->server;
    record_.player = world.rules->player;
    record_.types = world.rules->types;
  }
  gamelog::Frame frame;
  simulator::to_frame(world, frame);
  builder_->append_frame(frame);
}

void SituationRun::finish() {
  const analysis::Situation& situation = play_.situation();
  const analysis::Flow flow = analysis::build_flow(record_);
  const analysis::SituationFigures figures = analysis::figures_of(flow, 0, record_.frames());
  const std::string& log = book_.logs[base::index(situation.log)].name;

  SituationResult played{std::string(name(situation.kind)),
                         log,
                         situation.time,
                         static_cast<int>(record_.frames()) - 1,
                         analysis::situation_value(figures),
                         {}};
  const auto values = figures.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    played.figures[std::string(analysis::kFigureNames[i])] =
        std::round(values[i] * kPerOne) / kPerOne;
  }

  result_.situations.push_back(std::move(played));
  record_ = {};
  builder_.reset();
}

BookResult SituationRun::result() const {
  BookResult result = result_;
  for (const SituationResult& one : result.situations) result.value += one.value;
  if (!result.situations.empty()) result.value /= static_cast<double>(result.situations.size());
  return result;
}

}  // namespace cls::match
