// SQL of the tournament store, and the migration of older schemas.
#include "tournament/store/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <system_error>
#include <utility>

#include "base/catch_as_error.h"
#include "base/text/percent_encoding.h"
#include "base/text/stored_formats.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

using base::Error;
using base::Result;

// Version 2 replaced one column for each member of an outcome by the JSON column `outcome`.
constexpr int kBusyTimeoutMs = 5000;

// The generated columns keep the names of version 1, so that users' queries still work. Like
// there, texts are empty rather than null once a match has an outcome.
constexpr const char* kTables = R"(
CREATE TABLE match (
  number            INTEGER PRIMARY KEY,
  round             INTEGER NOT NULL,
  stage             TEXT    NOT NULL,
  pairing           INTEGER NOT NULL,
  left_team         INTEGER NOT NULL,
  right_team        INTEGER NOT NULL,
  seed              INTEGER NOT NULL,
  decides           INTEGER NOT NULL,
  state             TEXT    NOT NULL DEFAULT 'planned',
  attempts          INTEGER NOT NULL DEFAULT 0,
  settled           INTEGER NOT NULL DEFAULT 0,
  outcome           TEXT,
  end_reason        TEXT    AS (json_extract(outcome, '$.end_reason')),
  forfeit           INTEGER AS (json_extract(outcome, '$.forfeit')),
  left_score        INTEGER AS (json_extract(outcome, '$.score[0]')),
  right_score       INTEGER AS (json_extract(outcome, '$.score[1]')),
  left_penalties    INTEGER AS (json_extract(outcome, '$.penalty_score[0]')),
  right_penalties   INTEGER AS (json_extract(outcome, '$.penalty_score[1]')),
  fault             TEXT    AS (json_extract(outcome, '$.fault')),
  message           TEXT    AS (ifnull(json_extract(outcome, '$.message'), substr(outcome, 1, 0))),
  cycles            INTEGER AS (json_extract(outcome, '$.cycles')),
  wall_seconds      REAL    AS (json_extract(outcome, '$.wall_seconds')),
  run_seconds       REAL    AS (json_extract(outcome, '$.run_seconds')),
  cycles_per_second REAL    AS (json_extract(outcome, '$.cycles_per_second')),
  deterministic     INTEGER AS (json_extract(outcome, '$.deterministic')),
  mode              TEXT    AS (json_extract(outcome, '$.mode')),
  started           TEXT    AS (json_extract(outcome, '$.started')),
  ended             TEXT    AS (json_extract(outcome, '$.ended')),
  host              TEXT    AS (json_extract(outcome, '$.host')),
  load              REAL    AS (json_extract(outcome, '$.load')),
  version           TEXT    AS (json_extract(outcome, '$.version')),
  server            TEXT    AS (json_extract(outcome, '$.server')),
  folder            TEXT    AS (ifnull(json_extract(outcome, '$.folder'), substr(outcome, 1, 0))),
  left_decisions    INTEGER AS (json_extract(outcome, '$.left_figures.decisions')),
  left_late         INTEGER AS (json_extract(outcome, '$.left_figures.late')),
  left_missed       INTEGER AS (json_extract(outcome, '$.left_figures.missed')),
  left_rpc_p50_us   REAL    AS (json_extract(outcome, '$.left_figures.rpc_p50_us')),
  left_rpc_p99_us   REAL    AS (json_extract(outcome, '$.left_figures.rpc_p99_us')),
  left_cpu_seconds  REAL    AS (json_extract(outcome, '$.left_figures.cpu_seconds')),
  right_decisions   INTEGER AS (json_extract(outcome, '$.right_figures.decisions')),
  right_late        INTEGER AS (json_extract(outcome, '$.right_figures.late')),
  right_missed      INTEGER AS (json_extract(outcome, '$.right_figures.missed')),
  right_rpc_p50_us  REAL    AS (json_extract(outcome, '$.right_figures.rpc_p50_us')),
  right_rpc_p99_us  REAL    AS (json_extract(outcome, '$.right_figures.rpc_p99_us')),
  right_cpu_seconds REAL    AS (json_extract(outcome, '$.right_figures.cpu_seconds'))
);
CREATE INDEX match_open ON match (state) WHERE state IN ('running', 'failed');
)";

constexpr const char* kScheduleColumns =
    "number, round, stage, pairing, left_team, right_team, seed, decides, state, attempts, settled";

// The JSON of an outcome from the columns of version 1; NULL without an outcome.
constexpr const char* kOutcomeOfVersion1 = R"(
CASE WHEN end_reason IS NOT NULL THEN json_object(
  'end_reason', end_reason,
  'forfeit', json(iif(forfeit, 'true', 'false')),
  'score', json_array(left_score, right_score),
  'penalty_score', json(iif(left_penalties IS NULL OR right_penalties IS NULL, 'null',
                            json_array(left_penalties, right_penalties))),
  'fault', fault,
  'message', nullif(message, ''),
  'attempts', settled,
  'cycles', cycles,
  'wall_seconds', wall_seconds,
  'run_seconds', run_seconds,
  'cycles_per_second', cycles_per_second,
  'deterministic', json(iif(deterministic, 'true', 'false')),
  'mode', mode,
  'started', started,
  'ended', ended,
  'host', host,
  'load', load,
  'version', version,
  'server', server,
  'folder', nullif(folder, ''),
  'left_figures', json_object(
    'decisions', left_decisions, 'late', left_late, 'missed', left_missed,
    'rpc_p50_us', left_rpc_p50_us, 'rpc_p99_us', left_rpc_p99_us, 'cpu_seconds', left_cpu_seconds),
  'right_figures', json_object(
    'decisions', right_decisions, 'late', right_late, 'missed', right_missed,
    'rpc_p50_us', right_rpc_p50_us, 'rpc_p99_us', right_rpc_p99_us,
    'cpu_seconds', right_cpu_seconds)) END)";

int schema_version(const SQLite::Database& database) {
  SQLite::Statement query(database, "PRAGMA user_version");
  query.executeStep();
  return query.getColumn(0).getInt();
}

void check_not_newer(int version) {
  if (version <= base::kStoreSchema) return;
  throw SQLite::Exception(
      fmt::format("schema version {} is newer than this cls supports ({}); "
                  "use the cls that wrote it",
                  version, base::kStoreSchema));
}

// Creates the tables of an empty database, or those that replace version 1.
void update_schema(SQLite::Database& database) {
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  const bool migrate = schema_version(database) == 1;
  if (migrate) database.exec("ALTER TABLE match RENAME TO match_1; DROP INDEX match_open;");
  database.exec(kTables);
  if (migrate) {
    database.exec(
        fmt::format("INSERT INTO match ({0}, outcome) SELECT {0}, {1} FROM match_1;"
                    "DROP TABLE match_1;",
                    kScheduleColumns, kOutcomeOfVersion1));
  }
  database.exec(fmt::format("PRAGMA user_version = {}", base::kStoreSchema));
  transaction.commit();
}

// Values of a row, one after the other.
class Columns {
 public:
  explicit Columns(SQLite::Statement& row) : row_(row) {}

  std::string text() { return row_.getColumn(next_++).getString(); }
  int integer() { return row_.getColumn(next_++).getInt(); }
  std::int64_t long_integer() { return row_.getColumn(next_++).getInt64(); }

 private:
  SQLite::Statement& row_;
  int next_ = 0;
};

// The match in a row with kScheduleColumns and the outcome as JSON.
ScheduledMatch match_in(SQLite::Statement& row) {
  Columns columns(row);
  ScheduledMatch match;
  Fixture& fixture = match.fixture;
  fixture.index = columns.integer();
  fixture.round = columns.integer();
  fixture.stage = columns.text();
  fixture.pairing = columns.integer();
  fixture.left = columns.integer();
  fixture.right = columns.integer();
  fixture.seed = static_cast<std::uint64_t>(columns.long_integer());
  fixture.decides = columns.integer() != 0;

  const std::string state = columns.text();
  match.attempts = columns.integer();
  match.settled = columns.integer();
  if (state != "done" && state != "failed") return match;

  auto outcome = parse_outcome(columns.text());
  if (!outcome) {
    throw SQLite::Exception(
        fmt::format("match {}: corrupt outcome: {}", fixture.index, outcome.error().message));
  }
  match.outcome = *std::move(outcome);
  return match;
}

// Device and inode; zeros for a missing file.
std::array<std::uint64_t, 2> file_identity(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino};
}

// Runs `work` and turns exceptions of the library into an error that names the file.
template <typename Work>
auto guarded(const std::string& file, Work work) {
  return base::catch_as_error<SQLite::Exception>(file, std::move(work));
}

}  // namespace

Store::Store(std::unique_ptr<SQLite::Database> database)
    : database_(std::move(database)), file_(file_identity(database_->getFilename())) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store> Store::open(const std::filesystem::path& file) {
  return guarded(file.string(), [&] {
    auto database = std::make_unique<SQLite::Database>(
        file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyTimeoutMs);
    database->exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;");
    const int version = schema_version(*database);
    check_not_newer(version);
    if (version < base::kStoreSchema) update_schema(*database);
    return Store(std::move(database));
  });
}

namespace {

// "file:/home/ada/my%20cup/tournament.db?immutable=1"
std::string immutable_uri(const std::filesystem::path& file) {
  return "file:" + base::percent_encoded(std::filesystem::absolute(file).string()) + "?immutable=1";
}

// A reader of a WAL database writes too: the shared index beside the file. Where the folder is
// read-only, the file alone is the database, unless a `run` that was killed has left a log.
std::unique_ptr<SQLite::Database> database_to_read(const std::filesystem::path& file) {
  try {
    auto database =
        std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE, kBusyTimeoutMs);
    check_not_newer(schema_version(*database));
    return database;
  } catch (const SQLite::Exception& error) {
    constexpr int kReadOnly = 8;     // SQLITE_READONLY
    constexpr int kCannotOpen = 14;  // SQLITE_CANTOPEN
    if (error.getErrorCode() != kReadOnly && error.getErrorCode() != kCannotOpen) throw;

    std::error_code code;
    const auto log_bytes = std::filesystem::file_size(file.string() + "-wal", code);
    if (!code && log_bytes > 0) {
      throw SQLite::Exception(
          "a killed run has left results in tournament.db-wal, and the folder is read-only; copy "
          "the folder");
    }
  }

  auto database = std::make_unique<SQLite::Database>(
      immutable_uri(file), SQLite::OPEN_READONLY | SQLite::OPEN_URI, kBusyTimeoutMs);
  check_not_newer(schema_version(*database));
  return database;
}

}  // namespace

Result<Store> Store::open_to_read(const std::filesystem::path& file) {
  std::error_code code;
  if (!std::filesystem::exists(file, code)) {
    return Error{fmt::format("{}: no such file", file.string())};
  }
  return guarded(file.string(), [&] { return Store(database_to_read(file)); });
}

Result<std::vector<ScheduledMatch>> Store::matches() const {
  return guarded(database_->getFilename(), [&] {
    std::vector<ScheduledMatch> all;
    SQLite::Transaction snapshot(*database_);  // `cls tournament run` may migrate meanwhile
    const int version = schema_version(*database_);
    if (version == 0) return all;
    SQLite::Statement row(*database_,
                          fmt::format("SELECT {}, {} FROM match ORDER BY number", kScheduleColumns,
                                      version == 1 ? kOutcomeOfVersion1 : "outcome"));
    while (row.executeStep()) all.push_back(match_in(row));
    return all;
  });
}

// SQLite continues to write into a file that has no name any more.
void Store::check_file() const {
  if (file_identity(database_->getFilename()) == file_) return;
  throw SQLite::Exception(
      "was removed or replaced while it was in use; results since then are lost");
}

Result<void> Store::add(std::span<const Fixture> fixtures) {
  return guarded(database_->getFilename(), [&] {
    check_file();
    SQLite::Transaction transaction(*database_);
    SQLite::Statement insert(*database_,
                             "INSERT INTO match (number, round, stage, pairing, left_team, "
                             "right_team, seed, decides) VALUES (?, ?, ?, ?, ?, ?, ?, ?)");

    for (const Fixture& fixture : fixtures) {
      insert.bind(1, fixture.index);
      insert.bind(2, fixture.round);
      insert.bind(3, fixture.stage);
      insert.bind(4, fixture.pairing);
      insert.bind(5, fixture.left);
      insert.bind(6, fixture.right);
      insert.bind(7, static_cast<std::int64_t>(fixture.seed));
      insert.bind(8, fixture.decides ? 1 : 0);
      insert.exec();
      insert.reset();
    }

    transaction.commit();
  });
}

Result<std::vector<int>> Store::begin_attempts(std::span<const int> indices) {
  return guarded(database_->getFilename(), [&] {
    check_file();
    std::vector<int> attempts;
    SQLite::Transaction transaction(*database_);
    SQLite::Statement update(*database_,
                             "UPDATE match SET state = 'running', attempts = attempts + 1 "
                             "WHERE number = ? RETURNING attempts");
    for (const int index : indices) {
      update.bind(1, index);
      update.executeStep();
      attempts.push_back(update.getColumn(0).getInt());
      update.reset();
    }
    transaction.commit();
    return attempts;
  });
}

Result<std::vector<int>> Store::running() const {
  return guarded(database_->getFilename(), [&] {
    std::vector<int> numbers;
    if (schema_version(*database_) == 0) return numbers;
    SQLite::Statement row(*database_,
                          "SELECT number FROM match WHERE state = 'running' ORDER BY number");
    while (row.executeStep()) numbers.push_back(row.getColumn(0).getInt());
    return numbers;
  });
}

Result<void> Store::requeue(bool failed_too) {
  return guarded(database_->getFilename(), [&] {
    database_->exec(failed_too ? "UPDATE match SET state = 'planned' "
                                 "WHERE state IN ('running', 'failed')"
                               : "UPDATE match SET state = 'planned' WHERE state = 'running'");
  });
}

Result<void> Store::plan_again(int index, std::uint64_t seed) {
  return guarded(database_->getFilename(), [&] {
    SQLite::Statement update(
        *database_,
        "UPDATE match SET state = 'planned', outcome = NULL, seed = ?2 WHERE number = ?1");
    update.bind(1, index);
    update.bind(2, static_cast<std::int64_t>(seed));
    update.exec();
  });
}

Result<void> Store::remove_from(int index) {
  return guarded(database_->getFilename(), [&] {
    SQLite::Statement remove(*database_, "DELETE FROM match WHERE number >= ?1");
    remove.bind(1, index);
    remove.exec();
  });
}

Result<void> Store::finish(int index, const Outcome& outcome, bool final) {
  return guarded(database_->getFilename(), [&] {
    check_file();
    SQLite::Statement update(*database_,
                             "UPDATE match SET state = ?2, attempts = max(attempts, ?3), "
                             "settled = ?3, outcome = ?4 WHERE number = ?1");
    update.bind(1, index);
    update.bind(2, final ? "done" : "failed");
    update.bind(3, outcome.attempts);
    update.bind(4, format_outcome(outcome));
    update.exec();
  });
}

}  // namespace cls::tournament
