// Events follow from score and play mode, which every server reports.
#include "match/hooks/event_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/system/host.h"
#include "base/text/json_text.h"
#include "base/text/printable.h"
#include "soccer/play_mode.h"

namespace cls::match {
namespace {

constexpr std::chrono::milliseconds kPollInterval{100};

// `what`: ", goal by RED"; empty for the score alone.
EventDocument event_document(std::string_view event, const TeamNames& names, int left, int right,
                             int cycle, const std::string& what) {
  return {{"schema", "cls.event/1"},
          {"event", event},
          {"text", fmt::format("{} {}:{} {}{}", names.left, left, right, names.right, what)},
          {"time", base::utc_now()},
          {"left", names.left},
          {"right", names.right},
          {"score", {left, right}},
          {"cycle", cycle}};
}

EventDocument progress_event(std::string_view event, const TeamNames& names,
                             const MatchProgress& now, const std::string& what) {
  return event_document(event, names, now.left_score, now.right_score, now.cycle, what);
}

bool between_halves(soccer::PlayMode mode) {
  return mode == soccer::PlayMode::kBeforeKickOff || mode == soccer::PlayMode::kFirstHalfOver;
}

std::string value_text(const EventDocument& value) {
  if (value.is_null()) return "";
  return base::printable(value.is_string() ? value.get<std::string>() : value.dump());
}

}  // namespace

std::vector<EventDocument> EventFinder::follow(const MatchProgress& progress) {
  std::vector<EventDocument> events;
  if (!before_) {
    events.push_back(progress_event("start", names_, progress, ", kick-off"));
    before_ = progress;
    return events;
  }

  const auto add_goals = [&](int before, int now, const std::string& team, const char* side) {
    if (now <= before) return;
    events.push_back(progress_event("goal", names_, progress,
                                    fmt::format(", goal by {} (cycle {})", team, progress.cycle)));
    events.back()["side"] = side;
  };
  add_goals(before_->left_score, progress.left_score, names_.left, "left");
  add_goals(before_->right_score, progress.right_score, names_.right, "right");

  if (progress.cycle > 0 && between_halves(progress.mode) && !between_halves(before_->mode)) {
    events.push_back(progress_event("half-time", names_, progress, ", half time"));
    events.back()["half"] = ++halves_;
  }
  before_ = progress;
  return events;
}

EventDocument EventFinder::last(const MatchResult& result) const {
  const bool good = result.valid();
  std::string what = good ? ", final score" : fmt::format(", {}", name(result.end_reason));
  const bool shoot_out = result.left.penalty_score && result.right.penalty_score;
  if (good && shoot_out) {
    what = fmt::format(" ({}:{} penalties), final score", *result.left.penalty_score,
                       *result.right.penalty_score);
  }

  if (!result.message.empty()) what += ": " + result.message;
  EventDocument event = event_document(good ? "end" : "failure", names_, result.left.score,
                                       result.right.score, result.cycles, what);

  event["penalty_score"] =
      shoot_out ? EventDocument::array({*result.left.penalty_score, *result.right.penalty_score})
                : EventDocument(nullptr);
  event["end_reason"] = name(result.end_reason);
  event["message"] = result.message;
  return event;
}

std::vector<process::EnvironmentChange> event_environment(const EventDocument& event) {
  std::vector<process::EnvironmentChange> environment;
  for (const auto& [key, value] : event.items()) {
    std::string name = "CLS_" + key;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });

    if (value.is_array() && value.size() == 2) {
      const std::string ending = name.substr(4);  // CLS_LEFT_SCORE
      environment.push_back({"CLS_LEFT_" + ending, value_text(value[0])});
      environment.push_back({"CLS_RIGHT_" + ending, value_text(value[1])});
    } else if (value.is_primitive() && key != "schema") {
      environment.push_back({name, value_text(value)});
    }
  }
  return environment;
}

void EventCommand::on_folder(const std::filesystem::path& folder, const std::string& game_log) {
  folder_ = folder;
  runner_.emplace(folder, std::filesystem::path(), limit_);
  next_.on_folder(folder, game_log);
}

void EventCommand::on_cycle(const MatchProgress& progress) {
  for (EventDocument& event : finder_.follow(progress)) run(std::move(event));
  next_.on_cycle(progress);

  if (!runner_ || runner_->idle()) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - polled_ < kPollInterval) return;
  polled_ = now;
  warn(runner_->take_errors());
}

void EventCommand::finish(const MatchResult& result, const std::atomic<int>& stop_signal) {
  if (!runner_) return;
  run(finder_.last(result));
  warn(runner_->finish(stop_signal));
}

void EventCommand::run(EventDocument event) {
  if (!runner_) return;
  event["folder"] = folder_.string();
  runner_->start(
      {kEventHookName, command_, base::json_line(event) + "\n", event_environment(event)});
}

void EventCommand::warn(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) next_.on_warning(line);
}

}  // namespace cls::match
