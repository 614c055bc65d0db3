// The table of frames that the published data sets have (tracking.csv): a row for each frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/io/byte_sink.h"
#include "gamelog/rcg/frame_stream.h"
#include "gamelog/record/match_record.h"

namespace cls::analysis {

/// Columns of each player.
enum class TrackingColumns : std::uint8_t {
  kAll,        ///< 212 columns, as rcg2csv writes them today
  kPublished,  ///< 168: without view width and stamina, as in the data of 2021 and 2024
};

/// Writes the rows (docs/data.md) into `sink`, which must outlive the table. For logs of versions 4
/// to 6 and JSON the bytes are those of rcg2csv. Cells of values that the version of a log lacks
/// are empty. A log of the 2.5D server has the column b_z behind the others.
class TrackingTable : public gamelog::FrameListener {
 public:
  explicit TrackingTable(base::ByteSink& sink, TrackingColumns columns = TrackingColumns::kAll);

  void on_frame(const gamelog::MatchRecord& record, std::size_t frame) override;

 private:
  void write_heading();
  void count(int time);
  void set_teams(const gamelog::MatchRecord& record, std::uint32_t state);
  char* write_start(const gamelog::MatchRecord& record, std::size_t frame, char* to) const;
  char* write_players(const gamelog::MatchRecord& record, std::size_t frame, char* to) const;

  base::ByteSink& sink_;
  TrackingColumns columns_;
  std::string row_;
  std::size_t rows_ = 0;
  bool has_ball_height_ = false;  // of the first frame
  int time_ = 0;
  int stopped_ = 0;
  std::string teams_;  // cells of the team state
  std::uint32_t team_state_ = 0;
};

}  // namespace cls::analysis
