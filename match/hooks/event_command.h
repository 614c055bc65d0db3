// Events of a match for other programs: start, goal, half time, end, failure.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/text/json.h"
#include "match/result/match_observer.h"
#include "match/result/match_result.h"
#include "match/terms/endpoint.h"
#include "process/hook_runner.h"

namespace cls::match {

/// The document `cls.event/1` of an event (docs/formats/events.md), with a member for each variable
/// of event_environment().
using EventDocument = base::Json;

/// The name of commands for events in messages.
constexpr const char* kEventHookName = "on_event";

/// Finds the events in the progress of a match.
class EventFinder {
 public:
  explicit EventFinder(TeamNames names) : names_(std::move(names)) {}

  /// The events since the call before: "start" in the first call, "goal", "half-time".
  std::vector<EventDocument> follow(const MatchProgress& progress);

  /// The last event: "end", or "failure" of a match that is invalid or was interrupted.
  EventDocument last(const MatchResult& result) const;

 private:
  TeamNames names_;
  std::optional<MatchProgress> before_;
  int halves_ = 0;  ///< that are over
};

/// Variables CLS_EVENT, CLS_TEXT, CLS_LEFT_SCORE, ... with the members of a document.
std::vector<process::EnvironmentChange> event_environment(const EventDocument& event);

/// Passes everything to another observer, and events to a command.
class EventCommand : public MatchObserver {
 public:
  /// `next` must outlive this.
  EventCommand(MatchObserver& next, std::string command, std::chrono::milliseconds limit,
               TeamNames names)
      : next_(next), command_(std::move(command)), limit_(limit), finder_(std::move(names)) {}

  void on_folder(const std::filesystem::path& folder, const std::string& game_log) override;
  void on_phase(std::string_view what) override { next_.on_phase(what); }
  void on_cycle(const MatchProgress& progress) override;
  void on_notice(std::string_view line) override { next_.on_notice(line); }
  void on_warning(std::string_view line) override { next_.on_warning(line); }

  /// After the match: the last event. Waits as HookRunner::finish does; its failures are warnings.
  void finish(const MatchResult& result, const std::atomic<int>& stop_signal);

 private:
  void run(EventDocument event);
  void warn(const std::vector<std::string>& lines);

  MatchObserver& next_;
  std::string command_;
  std::chrono::milliseconds limit_;
  EventFinder finder_;
  std::filesystem::path folder_;
  std::optional<process::HookRunner> runner_;
  std::chrono::steady_clock::time_point polled_{};
};

}  // namespace cls::match
