// Follows the file of events by its size.
#include "tournament/run/event_feed.h"

#include <fmt/format.h>

#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include "base/system/host.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "match/hooks/event_command.h"
#include "tournament/report/report_model.h"
#include "tournament/store/folder.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Json;

// The whole lines that were appended since `position`.
std::string new_lines(const fs::path& file, std::uint64_t& position) {
  std::error_code code;
  const std::uintmax_t size = fs::file_size(file, code);
  if (code || size <= position) return "";

  std::string text(size - position, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(position));
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(base::index(stream.gcount()));
  text.resize(text.rfind('\n') + 1);  // npos + 1 is 0
  position += text.size();
  return text;
}

// Empty without such a member. Anything may write to the file, also programs of another host.
std::string text_of(const Json& event, const char* member) {
  const auto found = event.find(member);
  return found != nullptr && found->is_string() ? found->get<std::string>() : "";
}

bool is_end(const Json& event) {
  const std::string what = text_of(event, "event");
  return what == "end" || what == "failure";
}

}  // namespace

EventFeed::EventFeed(const TournamentConfig& config, fs::path folder)
    : config_(config), folder_(std::move(folder)) {
  if (!config_.execution.on_event.empty()) new_lines(folder_ / kMatchEvents, position_);
}

void EventFeed::poll(std::span<const ScheduledMatch> matches, process::HookRunner& hooks) {
  if (config_.execution.on_event.empty()) return;
  const std::string text = new_lines(folder_ / kMatchEvents, position_);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    Json event = Json::parse_or_discarded(text.substr(begin, end - begin));
    begin = end + 1;
    if (!event.is_object() || text_of(event, "schema") != "cls.event/1") continue;

    const auto index = match_number(text_of(event, "folder"));
    if (!index || *index < 1 || *index > std::ssize(matches)) continue;

    if (is_end(event)) ended_.insert(*index);
    pass_on(std::move(event), matches[base::index(*index) - 1], hooks);
  }
}

void EventFeed::settle(std::span<const ScheduledMatch> matches, const ScheduledMatch& match,
                       process::HookRunner& hooks) {
  if (config_.execution.on_event.empty()) return;
  poll(matches, hooks);
  const bool reported = ended_.erase(match.fixture.index) > 0;
  const Outcome& outcome = *match.outcome;
  if (reported || outcome.finished()) return;

  const std::string& left = config_.competition.team(match.fixture.left);
  const std::string& right = config_.competition.team(match.fixture.right);
  pass_on({{"schema", "cls.event/1"},
           {"event", "failure"},
           {"text", fmt::format("{} - {}, {}{}", left, right, name(outcome.end_reason),
                                outcome.message.empty() ? "" : ": " + outcome.message)},
           {"time", base::utc_now()},
           {"left", left},
           {"right", right},
           {"score", nullptr},
           {"cycle", outcome.cycles},
           {"end_reason", name(outcome.end_reason)},
           {"message", outcome.message},
           {"folder", outcome.folder.empty() ? "" : (folder_ / outcome.folder).string()}},
          match, hooks);
}

void EventFeed::pass_on(Json event, const ScheduledMatch& match, process::HookRunner& hooks) {
  event["tournament"] = tournament_name(config_, folder_);
  event["match"] = match.fixture.index;
  event["stage"] = stage_text(match.fixture);
  hooks.start({match::kEventHookName, config_.execution.on_event, base::json_line(event) + "\n",
               match::event_environment(event)});
}

}  // namespace cls::tournament
