// The database of a tournament: one SQLite file with a row for every scheduled match.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "league/matches/fixture.h"

namespace SQLite {
class Database;
}

namespace cls::tournament {

/// Commits every outcome to disk (WAL, synced) before the next match starts. One writer at a time;
/// readers may read meanwhile. A file that is removed or replaced is an error of the next write.
/// Table `match` holds each outcome as JSON (format_outcome) and has generated columns for queries
/// by sqlite3; see docs/tournaments.md.
class Store {
 public:
  /// Opens the file for writing. Creates it when missing, and migrates one of an older schema. The
  /// error names the file.
  static base::Result<Store> open(const std::filesystem::path& file);
  /// Opens an existing file for reading, of this schema or an older one, and leaves its schema.
  static base::Result<Store> open_to_read(const std::filesystem::path& file);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  /// All matches by number, with their outcomes.
  base::Result<std::vector<league::ScheduledMatch>> matches() const;

  /// Appends rows, all or none of them.
  base::Result<void> add(std::span<const league::Fixture> fixtures);

  /// Records that attempts at these matches start. Returns the attempts' numbers, from 1.
  base::Result<std::vector<int>> begin_attempts(std::span<const int> indices);

  /// Numbers of the matches that are running, or were when cls ended.
  base::Result<std::vector<int>> running() const;

  /// Plans running matches again; with `failed_too` also those whose outcome is not final.
  base::Result<void> requeue(bool failed_too);

  /// Plans a match again, with another seed.
  base::Result<void> plan_again(int index, std::uint64_t seed);

  /// Removes the matches from this number on.
  base::Result<void> remove_from(int index);

  /// Commits an outcome. One that is not `final` is valid until requeue().
  base::Result<void> finish(int index, const league::Outcome& outcome, bool final = true);

 private:
  explicit Store(std::unique_ptr<SQLite::Database> database);
  void check_file() const;

  std::unique_ptr<SQLite::Database> database_;
  std::array<std::uint64_t, 2> file_;  // device and inode
};

}  // namespace cls::tournament
