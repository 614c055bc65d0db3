// Reads and summarizes logs on several threads.
#include "analysis/results/read_results.h"

#include <utility>

#include "base/system/parallel.h"
#include "gamelog/files/log_reader.h"
#include "gamelog/rcg/rcg_writer.h"
#include "gamelog/rcl/rcl_reader.h"

namespace cls::analysis {
namespace {

ReadResult summarize_text_log(const std::string& path, const gamelog::RclRecord& text) {
  ReadResult result;
  result.usable = !text.lines.empty();
  result.summary = summarize(text);
  result.summary.file = path;
  result.errors = text.errors;
  result.error_file = path;
  return result;
}

bool needs_text_log(const gamelog::MatchRecord& record) {
  const auto& [left, right] = record.final_teams();
  const bool level_shoot_out = left.penalties_taken() + right.penalties_taken() > 0 &&
                               left.score == right.score &&
                               left.penalty_scored == right.penalty_scored;
  return level_shoot_out || record.version < gamelog::RcgVersion::kV4;
}

ReadResult summarize_game_log(const gamelog::MatchLogs& logs, const gamelog::MatchRecord& record) {
  ReadResult result;
  std::optional<gamelog::RclRecord> text;
  if (!logs.text.empty() && needs_text_log(record)) {
    auto read = gamelog::read_rcl_file(logs.text);
    if (read) text = std::move(*read);
  }

  result.usable = record.frames() > 0 || record.errors.empty();
  result.summary = summarize(record, text ? &*text : nullptr);
  result.summary.file = logs.game;
  result.summary.text_log = logs.text;
  result.errors = record.errors;
  result.error_file = logs.game;

  if (result.errors.empty() && text && !text->errors.empty()) {
    result.errors = text->errors;
    result.error_file = logs.text;
  }
  return result;
}

ReadResult read_match(const MatchInput& input) {
  const std::string& path = input.logs.game.empty() ? input.logs.text : input.logs.game;
  const auto log = gamelog::read_log_file(path);
  ReadResult result;

  if (!log) {
    result.unreadable = log.error().message;
    return result;
  }

  const auto* text = std::get_if<gamelog::RclRecord>(&*log);
  result = text != nullptr ? summarize_text_log(path, *text)
                           : summarize_game_log(input.logs, std::get<gamelog::MatchRecord>(*log));

  if (input.end) set_end(*input.end, result.summary);
  // It ends where its writer is.
  if (input.end && input.end->reason == kRunning) {
    result.errors = {};
    result.summary.parse_errors = 0;
  }

  // Logs of cls hold no date, so that equal matches give equal logs.
  std::string& date = result.summary.date;
  if (date.empty() || date == gamelog::LogDate().minute) date = input.date;
  return result;
}

}  // namespace

std::vector<ReadResult> read_results(const std::vector<MatchInput>& matches, std::size_t jobs,
                                     const std::function<void(std::size_t)>& on_done) {
  std::vector<ReadResult> results(matches.size());
  const auto work = [&](std::size_t i) { results[i] = read_match(matches[i]); };
  base::parallel_for(matches.size(), jobs, work, on_done);
  return results;
}

}  // namespace cls::analysis
