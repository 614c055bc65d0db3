// Checks invariants of log readers, writers and statistics.
#include "tests/fuzz/log_checks.h"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "analysis/results/match_summary.h"
#include "analysis/results/results_text.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/statistics_json.h"
#include "analysis/statistics/statistics_text.h"
#include "analysis/tables/log_tables.h"
#include "base/io/byte_sink.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/record_writer.h"
#include "gamelog/rcl/logged_commands.h"
#include "gamelog/rcl/rcl_reader.h"
#include "tests/fuzz/require.h"

namespace cls::tests {
namespace {

using namespace cls::base;
using namespace cls::gamelog;
using namespace cls::analysis;

// More frames make statistics slower without finding more.
constexpr std::size_t kEnoughFrames = 300;

MatchRecord read(std::string_view bytes) {
  MemorySource source(bytes);
  return read_rcg(source);
}

std::string written(const MatchRecord& record, RcgVersion version) {
  StringSink sink;
  write_rcg(record, version, sink);
  return sink.bytes();
}

void check_record(const MatchRecord& record) {
  const std::size_t frames = record.frames();
  require(record.players.state.size() == frames * kSlots, "a state for every player and frame");
  require(record.players.counters.size() == frames * kSlots, "counters for every player and frame");
  require(record.teams.size() >= 1, "a first state of the teams");
  for (std::size_t i = 0; i < frames; ++i) {
    require(record.team_state[i] < record.teams.size(), "frames name a state of the teams");
    require(record.stopped[i] >= 0, "stopped time is not negative");
  }
  for (const Note& note : record.notes) require(note.frame <= frames, "notes lie between frames");
  require(record.errors.first.size() <= record.errors.count, "errors are counted");
}

// After one round trip through a version, a second one changes nothing.
void check_writing(const MatchRecord& record, RcgVersion version) {
  const std::string once = written(record, version);
  const MatchRecord again = read(once);
  check_record(again);
  require(again.frames() == record.frames(), "no frame is lost in writing");
  require(again.version == version, "the version that was wanted");
  require(written(again, version) == once, "writing twice gives the same");
}

void check_reckoning(const MatchRecord& record, const RclRecord* text) {
  const MatchSummary summary = summarize(record, text);
  const auto format = static_cast<ResultsFormat>(record.notes.size() % 4);
  require(!format_results({summary, summary}, format).empty(), "a table of results");
  if (record.frames() > kEnoughFrames) return;
  const MatchStatistics statistics = compute_statistics(record, text);
  base::StringSink table;
  write_frames_arrow(record, table);
  write_events_arrow(statistics.flow, table);
  require(table.bytes().ends_with("ARROW1"), "frames and events as tables");
  // Slow to write, and hardly dependent on the input.
  if (record.notes.size() % 8 != 0) return;
  require(!statistics_json(summary, statistics, true).empty(), "statistics as JSON");
  require(!statistics_text(summary, statistics).empty(), "statistics as text");
}

constexpr std::string_view kMadeUpMatch =
    "ULG6\n(team 1 A B 0 0)\n(playmode 1 play_on)\n"
    "(show 1 ((b) 0 0 0 0) ((l 1) 0 0x1 1 2 0 0 0 0 (v h 120) (fp 0 0) (s 8000 1 1 130600) (c 0 0 "
    "0 0 0 0 0 0 0 0 0 0)))\n"
    "(show 2 ((b) 0 0 0 0) ((l 1) 0 0x1 1 2 0 0 0 0 (v h 120) (fp 0 0) (s 8000 1 1 130600) (c 1 0 "
    "0 0 0 0 0 0 0 0 0 0)))\n"
    "(show 3 ((b) 1 0 0 0) ((l 1) 0 0x1 1 2 0 0 0 0 (v h 120) (fp 0 0) (s 8000 1 1 130600) (c 1 0 "
    "0 0 0 0 0 0 1 0 0 0)))\n";

}  // namespace

void check_game_log(std::string_view bytes) {
  auto source = decompress(std::make_unique<MemorySource>(bytes));
  const MatchRecord record = read_rcg(*source);
  check_record(record);
  // One of five versions per input; a fuzzer reaches all of them.
  check_writing(record, static_cast<RcgVersion>(static_cast<int>(RcgVersion::kV4) +
                                                static_cast<int>(bytes.size() % 5)));
  check_reckoning(record, nullptr);
}

void check_text_log(std::string_view bytes) {
  auto source = decompress(std::make_unique<MemorySource>(bytes));
  const RclRecord text = read_rcl(*source);
  for (const RclLine& line : text.lines) {
    require(line.offset + line.length <= text.text.size(), "texts lie within the text");
    const bool player = line.source == RclSource::kPlayer;
    require(!player || (line.unum >= 1 && line.unum <= soccer::kPlayersPerTeam),
            "numbers from 1 to 11");
    const bool named = player || line.source == RclSource::kCoach;
    require(!named || line.team < text.teams.size(), "names that are known");
    CommandCursor cursor(text.text_of(line));
    LoggedCommand command;
    std::size_t commands = 0;
    while (cursor.next(command)) ++commands;
    require(commands <= line.length, "no command out of nothing");
  }

  base::StringSink table;
  analysis::write_commands_arrow(text, table);
  require(table.bytes().ends_with("ARROW1"), "commands as a table");
  const MatchSummary summary = summarize(text);
  require(!format_results({summary}, ResultsFormat::kJson).empty(), "results of a text log");
  static const MatchRecord made_up = read(kMadeUpMatch);
  check_reckoning(made_up, &text);
}

}  // namespace cls::tests
