// The memory of a tournament: one SQLite file with a row for every scheduled match.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "orchestration/tournament/schedule/fixture.h"

namespace SQLite {
class Database;
}

namespace cls::orchestration::tournament {

/// Rows from the start, an outcome committed (WAL, synced to disk) before the next match begins.
/// One writer at a time; readers may look while it writes. Table `match` has one column a field of
/// Fixture and Outcome; docs/tournaments.md lists them for use with sqlite3.
class Store {
 public:
  /// Opens the file, creates it with its tables when it is not there. The error names the file.
  static base::Result<Store> open(const std::filesystem::path& file);
  /// For looking only; an error when there is no such file.
  static base::Result<Store> open_to_read(const std::filesystem::path& file);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  /// All matches by number, with their outcomes.
  base::Result<std::vector<ScheduledMatch>> matches() const;

  /// Appends rows, all or none of them.
  base::Result<void> add(std::span<const Fixture> fixtures);

  /// Notes that attempts at these matches begin and returns their numbers, from 1.
  base::Result<std::vector<int>> begin_attempts(std::span<const int> indices);

  /// Numbers of the matches that are being played, or were when cls ended.
  base::Result<std::vector<int>> running() const;

  /// Matches noted as running wait to be played again; with `failed_too` also those whose outcome
  /// was committed as not final.
  base::Result<void> put_back(bool failed_too);

  /// Commits an outcome. One that is not `final` stands until put_back.
  base::Result<void> finish(int index, const Outcome& outcome, bool final = true);

 private:
  explicit Store(std::unique_ptr<SQLite::Database> database);

  std::unique_ptr<SQLite::Database> database_;
};

}  // namespace cls::orchestration::tournament
