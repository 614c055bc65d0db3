// One match after the other on each thread.
#include "gamelog/results/read_results.h"

#include <optional>
#include <utility>

#include "gamelog/parallel.h"
#include "gamelog/rcg_reader.h"
#include "gamelog/rcl_reader.h"

namespace cls::gamelog {
namespace {

ReadResult read_text_log_only(const MatchLogs& logs) {
  ReadResult result;
  const auto text = read_rcl_file(logs.text);
  if (!text) {
    result.unreadable = text.error().message;
    return result;
  }
  result.usable = !text->lines.empty();
  result.summary = summarize(*text);
  result.summary.file = logs.text;
  result.damage = text->damage;
  result.damaged_file = logs.text;
  return result;
}

bool needs_text_log(const MatchRecord& record) {
  const auto& [left, right] = record.final_teams();
  const bool level_shoot_out = left.penalties_taken() + right.penalties_taken() > 0 &&
                               left.score == right.score &&
                               left.penalty_scored == right.penalty_scored;
  return level_shoot_out || record.version < RcgVersion::kV4;
}

ReadResult read_match(const MatchLogs& logs) {
  if (logs.game.empty()) return read_text_log_only(logs);
  ReadResult result;
  const auto record = read_rcg_file(logs.game);
  if (!record) {
    result.unreadable = record.error().message;
    return result;
  }
  std::optional<RclRecord> text;
  if (!logs.text.empty() && needs_text_log(*record)) {
    auto read = read_rcl_file(logs.text);
    if (read) text = std::move(*read);
  }
  result.usable = record->frames() > 0 || record->damage.empty();
  result.summary = summarize(*record, text ? &*text : nullptr);
  result.summary.file = logs.game;
  result.summary.text_log = logs.text;
  result.damage = record->damage;
  result.damaged_file = logs.game;
  if (result.damage.empty() && text && !text->damage.empty()) {
    result.damage = text->damage;
    result.damaged_file = logs.text;
  }
  return result;
}

}  // namespace

std::vector<ReadResult> read_results(const std::vector<MatchLogs>& matches, std::size_t jobs) {
  std::vector<ReadResult> results(matches.size());
  for_each_index(matches.size(), jobs, [&](std::size_t i) { results[i] = read_match(matches[i]); });
  return results;
}

}  // namespace cls::gamelog
