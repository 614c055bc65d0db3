// The tables of a log that the published data sets have, as CSV and as Arrow files, and its
// commands.
#pragma once

#include <string>

#include "analysis/play/flow.h"
#include "base/io/byte_sink.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"

namespace cls::analysis {

// The columns are those of docs/data.md; tracking_table.h has the CSV table of frames. In Arrow
// files columns have types and units, and what the version of a log lacks is null.

/// event.csv: a row for each event, which is what the ball did between two touches, sorted by the
/// time of its first touch.
std::string event_table(const Flow& flow);
void write_events_arrow(const Flow& flow, base::ByteSink& sink);

/// player_types.csv: a row for each player type of the log, in its order: the bytes of rcg2csv.
/// Empty for a log without types (versions 1 and 2).
std::string player_type_table(const gamelog::MatchRecord& record);

/// A row for each frame: the columns of tracking.csv.
void write_frames_arrow(const gamelog::MatchRecord& record, base::ByteSink& sink);

/// A row for each command of players, coaches and trainers in the text log.
void write_commands_arrow(const gamelog::RclRecord& text, base::ByteSink& sink);

}  // namespace cls::analysis
