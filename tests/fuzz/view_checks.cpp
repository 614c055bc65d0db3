// Checks that readers of streams accept nothing that they cannot write.
#include "tests/fuzz/view_checks.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>

#include "analysis/results/match_summary.h"
#include "base/io/byte_sink.h"
#include "gamelog/record/match_record.h"
#include "tests/fuzz/require.h"
#include "tests/viewer/record_difference.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/decisions/decision_table.h"
#include "viewer/page/page.h"
#include "viewer/stream/chunk_reader.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::tests {
namespace {

void check_record(const gamelog::MatchRecord& record) {
  for (std::size_t i = 0; i < record.frames(); ++i) {
    require(record.team_state[i] < record.teams.size(), "frames name a state of the teams");
    require(record.stopped[i] >= 0, "stopped time is not negative");
    static_cast<void>(gamelog::frame_at(record, i));
  }
}

// Names of teams and messages of a match do not break its page.
void check_page(const gamelog::MatchRecord& record, std::string_view stream) {
  const auto page = viewer::write_page(analysis::summarize(record, nullptr), stream, {});
  const auto read = viewer::read_page(page);
  require(read.ok(), "a written page can be read", read ? "" : read.error().message);
  const std::string difference = record_difference(record, read->record);
  require(difference.empty(), "a page has the match of its stream", difference);
}

// Notes may name frames that never came, and a record read without its end has no errors.
void check_match(const viewer::StreamMatch& match) {
  check_record(match.record);
  if (!match.ended) return;
  const std::string stream = viewer::write_stream(match.record, {}, match.statistics);
  const auto again = viewer::read_stream(stream);
  require(again.ok(), "a written stream can be read", again ? "" : again.error().message);
  const std::string difference = record_difference(match.record, again->record);
  require(difference.empty(), "nothing is lost in writing", difference);
  // Slower than everything else here.
  if (stream.size() % 8 == 0) check_page(match.record, stream);
}

/// Decisions that were read are the same when they were written again.
void check_decisions(std::string_view bytes) {
  const auto decisions = viewer::read_decisions(bytes);
  static_cast<void>(viewer::select_players(bytes, {7}));
  const auto again = viewer::select_cycles(bytes, {{0, 1 << 30}});
  require(decisions.ok() == again.ok(), "cycles of readable decisions can be selected");
  if (!decisions) return;
  base::StringSink table;
  viewer::write_decisions_arrow({*decisions}, table);
  require(table.bytes().ends_with("ARROW1"), "decisions are a table");
  const auto read = viewer::read_decisions(*again);
  require(read.ok(), "written decisions can be read", read ? "" : read.error().message);

  for (std::size_t i = 0; i < decisions->players.size(); ++i) {
    for (const viewer::DecisionSample& sample : read->players[i])
      require(sample.cycle >= 0, "only chosen cycles are kept");
    if (decisions->players[i].size() != read->players[i].size()) continue;
    for (std::size_t k = 0; k < read->players[i].size(); ++k) {
      const auto& [a, b] = std::tie(decisions->players[i][k], read->players[i][k]);
      require(a.reply == b.reply && a.commands == b.commands && a.drawings == b.drawings &&
                  a.ball_age == b.ball_age,
              "nothing is lost in writing decisions");
    }
  }
}

}  // namespace

void check_view(std::string_view bytes) {
  check_decisions(bytes);
  if (viewer::looks_like_page(bytes)) {
    if (const auto match = viewer::read_page(bytes)) check_match(*match);
    return;
  }
  viewer::ChunkReader whole;
  const bool good = whole.add(bytes).ok();
  check_match(whole.match());
  viewer::ChunkReader pieces;
  const std::size_t middle = bytes.size() / 2;
  const bool again =
      pieces.add(bytes.substr(0, middle)).ok() && pieces.add(bytes.substr(middle)).ok();
  require(good == again, "pieces of any size are the same");
  if (!good) return;
  const std::string difference = record_difference(whole.match().record, pieces.match().record);
  require(difference.empty(), "pieces give the same record", difference);
}

}  // namespace cls::tests
