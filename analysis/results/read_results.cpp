// One match after the other on each thread.
#include "analysis/results/read_results.h"

#include <optional>
#include <utility>

#include "analysis/results/match_document.h"
#include "base/system/parallel.h"
#include "gamelog/files/log_reader.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::analysis {
namespace {

ReadResult read_text_log_only(const std::string& path, const gamelog::RclRecord& text) {
  ReadResult result;
  result.usable = !text.lines.empty();
  result.summary = summarize(text);
  result.summary.file = path;
  add_end_reason(path, result.summary);
  result.damage = text.damage;
  result.damaged_file = path;
  return result;
}

bool needs_text_log(const gamelog::MatchRecord& record) {
  const auto& [left, right] = record.final_teams();
  const bool level_shoot_out = left.penalties_taken() + right.penalties_taken() > 0 &&
                               left.score == right.score &&
                               left.penalty_scored == right.penalty_scored;
  return level_shoot_out || record.version < gamelog::RcgVersion::kV4;
}

ReadResult read_game_log(const gamelog::MatchLogs& logs, const gamelog::MatchRecord& record) {
  ReadResult result;
  std::optional<gamelog::RclRecord> text;
  if (!logs.text.empty() && needs_text_log(record)) {
    auto read = gamelog::read_rcl_file(logs.text);
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

ReadResult read_match(const gamelog::MatchLogs& logs) {
  const std::string& path = logs.game.empty() ? logs.text : logs.game;
  const auto log = gamelog::read_log_file(path);
  if (!log) {
    ReadResult result;
    result.unreadable = log.error().message;
    return result;
  }
  if (const auto* text = std::get_if<gamelog::RclRecord>(&*log))
    return read_text_log_only(path, *text);
  return read_game_log(logs, std::get<gamelog::MatchRecord>(*log));
}

}  // namespace

std::vector<ReadResult> read_results(const std::vector<gamelog::MatchLogs>& matches,
                                     std::size_t jobs,
                                     const std::function<void(std::size_t)>& on_done) {
  std::vector<ReadResult> results(matches.size());
  const auto work = [&](std::size_t i) { results[i] = read_match(matches[i]); };
  base::for_each_index(matches.size(), jobs, work, on_done);
  return results;
}

}  // namespace cls::analysis
