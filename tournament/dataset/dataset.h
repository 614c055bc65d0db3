// A data set: the matches of a tournament with full state and world models, in few small files that
// are the same in each run of the same specification.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "league/matches/fixture.h"
#include "tournament/config/config.h"

namespace cls::tournament {

// Names inside a data set; docs/data.md describes the files.
inline constexpr const char* kDatasetPlan = "dataset.toml";      ///< the specification
inline constexpr const char* kDatasetMatches = "matches.jsonl";  ///< a DatasetMatch a line
inline constexpr const char* kDatasetCard = "README.md";
inline constexpr const char* kDatasetShards = "shards";
/// The tournament that plays the matches; needed to resume, not to use the data set.
inline constexpr const char* kDatasetWork = "work";

struct DatasetFile {
  std::string path;  ///< inside the data set
  std::uint64_t bytes = 0;
  std::string sha256;  ///< hexadecimal digits

  bool operator==(const DatasetFile&) const = default;
};

struct DatasetMatch {
  Fixture fixture;
  std::string left;  ///< team
  std::string right;
  std::pair<int, int> score;
  std::string end_reason;  ///< "finished"; otherwise the match has no files
  int cycles = 0;
  bool deterministic = true;
  std::string version;  ///< of cls
  /// The full state (cls.view/1), then the recorded world models of the left and right side.
  std::vector<DatasetFile> files;
};

/// How much the matches of a data set are.
struct DatasetSize {
  std::size_t valid = 0;    ///< matches with files
  std::uint64_t bytes = 0;  ///< of all files

  double megabytes() const { return static_cast<double>(bytes) / 1e6; }
  /// Of a match with files; 0 without any.
  double megabytes_each() const {
    return megabytes() / static_cast<double>(valid == 0 ? 1 : valid);
  }
};
DatasetSize size_of(const std::vector<DatasetMatch>& matches);

/// True if `folder` holds a finished data set.
bool is_dataset(const std::filesystem::path& folder);

/// The configuration of the matches of a data set: world models are recorded, logs are not
/// compressed, because they are packed. Settings of `config` go first.
TournamentConfig dataset_config(TournamentConfig config);

/// Writes the files of a played match below `dataset`. `folder` is its match folder. The same match
/// gives the same bytes. An error if a file cannot be read or written.
base::Result<DatasetMatch> pack_match(const TournamentConfig& config, const ScheduledMatch& match,
                                      const std::filesystem::path& folder,
                                      const std::filesystem::path& dataset);

/// A line of matches.jsonl, with its line feed.
std::string format_dataset_match(const DatasetMatch& match);
base::Result<DatasetMatch> parse_dataset_match(std::string_view line);

/// All lines of matches.jsonl. The error names file and line.
base::Result<std::vector<DatasetMatch>> read_dataset_matches(const std::filesystem::path& folder);

/// Where `file` is in the data set `folder`. An error unless it is a regular file of its size below
/// `folder`, at a relative path without "..": a list of a stranger names what it likes.
base::Result<std::filesystem::path> find_dataset_file(const std::filesystem::path& folder,
                                                      const DatasetFile& file);

/// What it takes to play `fixture` again beyond `cls` itself, for a user to judge: "A is
/// 'run:./team --port {port}'". Empty: both sides are built in, on the embedded server.
std::string foreign_part(const TournamentConfig& config, const Fixture& fixture);

/// The specification. Relative paths of sides start in the folder of the original one, as long as
/// work/ is there.
base::Result<TournamentConfig> read_dataset_plan(const std::filesystem::path& folder);

/// Writes what is not a match: specification, list of matches, card. `matches` are in order. Files
/// in the shards that belong to none of them are removed.
base::Result<void> write_dataset(const TournamentConfig& config,
                                 const std::vector<DatasetMatch>& matches,
                                 const std::filesystem::path& folder);

}  // namespace cls::tournament
