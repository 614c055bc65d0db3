// The columns of a match in a stream: names, units, codings, and where a MatchRecord has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "gamelog/record/match_record.h"

namespace cls::viewer {

/// How the integers of a series are stored (docs/formats/view.md).
enum class Coding : std::uint8_t {
  kChanges,   ///< "c": only entries that differ from the previous frame
  kFirst,     ///< "d1": difference to the previous frame
  kSecond,    ///< "d2": difference of differences
  kAngle,     ///< "da": difference, wrapped to half a turn
  kVelocity,  ///< "dv": difference to the displacement times the decay of the object
};

/// "c", "d1", ...
std::string_view name(Coding coding);
/// The coding of a name; nothing for another text.
std::optional<Coding> parse_coding(std::string_view text);

/// Integer that stands for a point that does not exist.
constexpr std::int64_t kNone = -(std::int64_t{1} << 31);

/// One column. Values are at `frame * series + slot` in the record; `load` and `store` copy `count`
/// of them from `first` on. A column is either of integers or of reals.
struct ColumnSpec {
  std::string_view name;
  Coding coding;
  std::size_t series;        ///< 1, or 22: one per player slot
  int scale = 0;             ///< stored integers per unit; 0: a column of integers
  int compact_scale = 0;     ///< `scale` of compact streams; 0: they lack this column of reals
  bool optional = false;     ///< NaN means: no value, and is stored as kNone
  std::string_view of = {};  ///< kVelocity: the column of positions
  bool of_height = false;    ///< only in streams of records with MatchRecord::has_ball_height
  std::int64_t min = 0;      ///< integers: smallest and largest value that the record can hold
  std::int64_t max = 0;

  using Record = gamelog::MatchRecord;
  void (*load_integers)(const Record&, std::size_t first, std::size_t count,
                        std::int64_t* to) = nullptr;
  void (*store_integers)(Record&, std::size_t first, std::size_t count,
                         const std::int64_t* from) = nullptr;
  void (*load_reals)(const Record&, std::size_t first, std::size_t count, float* to) = nullptr;
  void (*store_reals)(Record&, std::size_t first, std::size_t count, const float* from) = nullptr;

  bool is_real() const { return scale != 0; }
};

/// All columns in the order of the stream: the positions of a velocity, and player types, come
/// before the velocities.
const std::vector<ColumnSpec>& column_table();

/// The column of that name; null if there is none.
const ColumnSpec* find_column(std::string_view name);

}  // namespace cls::viewer
