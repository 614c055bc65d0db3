// The tables of a match as Arrow files: the columns of the CSV tables with types and units.
#pragma once

#include "analysis/play/flow.h"
#include "base/io/byte_sink.h"
#include "gamelog/rcl/rcl_record.h"
#include "gamelog/record/match_record.h"

namespace cls::analysis {

// The columns are those of docs/data.md. What the version of a log lacks is null.

/// A row for each frame: the columns of tracking.csv.
void write_frames_arrow(const gamelog::MatchRecord& record, base::ByteSink& sink);

/// A row for each event: the columns of event.csv.
void write_events_arrow(const Flow& flow, base::ByteSink& sink);

/// A row for each command of players, coaches and trainers in the text log.
void write_commands_arrow(const gamelog::RclRecord& text, base::ByteSink& sink);

}  // namespace cls::analysis
