// The trajectory challenge: predict the 30 frames before a goal of the left team. Tests, checks and
// scores are those of the challenge's public scripts (docs/data.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/tables/stp_rows.h"
#include "base/io/byte_sink.h"
#include "base/io/byte_source.h"
#include "base/result.h"

namespace cls::analysis {

inline constexpr int kStpFrames = 30;

/// The last cycle that a test shows: 30 before the first goal of the left team that 50 rows of
/// play_on precede. Nothing without such a goal.
base::Result<std::optional<int>> stp_last_cycle(base::ByteSource& tracking);

/// The files of a match that a test has the start of.
enum class StpFile : std::uint8_t { kTracking, kEvents, kGameLog, kTextLog };

/// Copies the lines before the first that is later than `last_cycle`; CR LF becomes a line feed.
base::Result<void> cut_stp_file(base::ByteSource& from, StpFile file, int last_cycle,
                                base::ByteSink& to);

/// Places of 30 frames.
struct StpPrediction {
  std::vector<std::int64_t> numbers;
  std::vector<std::array<soccer::Vec2, kStpAgents>> places;
};

/// A table of at most 10 000 rows.
base::Result<StpPrediction> read_stp_prediction(base::ByteSource& table, StpColumns columns);

/// The last row of a test.
base::Result<StpRow> read_last_stp_row(base::ByteSource& test, StpColumns columns);

/// Why a prediction for a test that ends with row `last` is not valid; nothing if it is.
std::optional<std::string> check_stp_prediction(const StpPrediction& prediction, std::int64_t last);

/// Mean distance of the left players and the ball, meters. NaN where a place is unknown.
struct StpScore {
  double average = 0.0;   ///< of all frames
  double endpoint = 0.0;  ///< of the last one, which decides
};

/// `truth`: the tracking table of the whole match; `last`: the last row of the test.
base::Result<StpScore> score_stp_prediction(const StpPrediction& prediction,
                                            base::ByteSource& truth, std::int64_t last);

/// Baselines.
enum class StpModel : std::uint8_t {
  kVelocity,  ///< all keep their velocity
  kGoal,      ///< the ball runs into the goal, and the players go along
};

/// Predictions from the last row of a test, which must have its motion.
StpPrediction predict_stp(StpModel model, const StpRow& last);

/// A table that the scripts read.
std::string format_stp_prediction(const StpPrediction& prediction);

}  // namespace cls::analysis
