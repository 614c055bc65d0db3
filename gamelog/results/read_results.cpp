// One match after the other on each thread.
#include "gamelog/results/read_results.h"

#include <optional>
#include <utility>

#include "gamelog/log_reader.h"
#include "gamelog/parallel.h"
#include "gamelog/rcl_reader.h"
#include "gamelog/results/match_document.h"

namespace cls::gamelog {
namespace {

ReadResult read_text_log_only(const std::string& path, const RclRecord& text) {
  ReadResult result;
  result.usable = !text.lines.empty();
  result.summary = summarize(text);
  result.summary.file = path;
  add_end_reason(path, result.summary);
  result.damage = text.damage;
  result.damaged_file = path;
  return result;
}

bool needs_text_log(const MatchRecord& record) {
  const auto& [left, right] = record.final_teams();
  const bool level_shoot_out = left.penalties_taken() + right.penalties_taken() > 0 &&
                               left.score == right.score &&
                               left.penalty_scored == right.penalty_scored;
  return level_shoot_out || record.version < RcgVersion::kV4;
}

ReadResult read_game_log(const MatchLogs& logs, const MatchRecord& record) {
  ReadResult result;
  std::optional<RclRecord> text;
  if (!logs.text.empty() && needs_text_log(record)) {
    auto read = read_rcl_file(logs.text);
    if (read) text = std::move(*read);
  }
  result.usable = record.frames() > 0 || record.damage.empty();
  result.summary = summarize(record, text ? &*text : nullptr);
  result.summary.file = logs.game;
  result.summary.text_log = logs.text;
  add_end_reason(logs.game, result.summary);
  result.damage = record.damage;
  result.damaged_file = logs.game;
  if (result.damage.empty() && text && !text->damage.empty()) {
    result.damage = text->damage;
    result.damaged_file = logs.text;
  }
  return result;
}

ReadResult read_match(const MatchLogs& logs) {
  const std::string& path = logs.game.empty() ? logs.text : logs.game;
  const auto log = read_log_file(path);
  if (!log) {
    ReadResult result;
    result.unreadable = log.error().message;
    return result;
  }
  if (const auto* text = std::get_if<RclRecord>(&*log)) return read_text_log_only(path, *text);
  return read_game_log(logs, std::get<MatchRecord>(*log));
}

}  // namespace

std::vector<ReadResult> read_results(const std::vector<MatchLogs>& matches, std::size_t jobs,
                                     const std::function<void(std::size_t)>& on_done) {
  std::vector<ReadResult> results(matches.size());
  const auto work = [&](std::size_t i) { results[i] = read_match(matches[i]); };
  for_each_index(matches.size(), jobs, work, on_done);
  return results;
}

}  // namespace cls::gamelog
