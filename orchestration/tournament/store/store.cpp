// SQL behind the store.
#include "orchestration/tournament/store/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <functional>
#include <system_error>
#include <utility>

#include "soccer/side_name.h"

namespace cls::orchestration::tournament {
namespace {

using base::Error;
using base::Result;

constexpr int kSchemaVersion = 1;
constexpr int kBusyMs = 5000;

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
  end_reason        TEXT,
  forfeit           INTEGER,
  left_score        INTEGER,
  right_score       INTEGER,
  left_penalties    INTEGER,
  right_penalties   INTEGER,
  fault             TEXT,
  message           TEXT,
  cycles            INTEGER,
  wall_seconds      REAL,
  run_seconds       REAL,
  cycles_per_second REAL,
  deterministic     INTEGER,
  mode              TEXT,
  started           TEXT,
  ended             TEXT,
  host              TEXT,
  load              REAL,
  version           TEXT,
  server            TEXT,
  folder            TEXT,
  left_decisions    INTEGER,
  left_late         INTEGER,
  left_missed       INTEGER,
  left_rpc_p50_us   REAL,
  left_rpc_p99_us   REAL,
  left_cpu_seconds  REAL,
  right_decisions   INTEGER,
  right_late        INTEGER,
  right_missed      INTEGER,
  right_rpc_p50_us  REAL,
  right_rpc_p99_us  REAL,
  right_cpu_seconds REAL
);
CREATE INDEX match_open ON match (state) WHERE state IN ('running', 'failed');
)";

constexpr const char* kAdd =
    "INSERT INTO match (number, round, stage, pairing, left_team, right_team, seed, decides) "
    "VALUES (?, ?, ?, ?, ?, ?, ?, ?)";

constexpr const char* kFinish = R"(
UPDATE match SET state = ?2, end_reason = ?3, forfeit = ?4, left_score = ?5, right_score = ?6,
  left_penalties = ?7, right_penalties = ?8, fault = ?9, message = ?10,
  attempts = max(attempts, ?11), settled = ?11,
  cycles = ?12, wall_seconds = ?13, run_seconds = ?14, cycles_per_second = ?15,
  deterministic = ?16, mode = ?17, started = ?18, ended = ?19, host = ?20, load = ?21,
  version = ?22, server = ?23, folder = ?24,
  left_decisions = ?25, left_late = ?26, left_missed = ?27, left_rpc_p50_us = ?28,
  left_rpc_p99_us = ?29, left_cpu_seconds = ?30,
  right_decisions = ?31, right_late = ?32, right_missed = ?33, right_rpc_p50_us = ?34,
  right_rpc_p99_us = ?35, right_cpu_seconds = ?36
WHERE number = ?1)";

constexpr const char* kSelect = R"(
SELECT number, round, stage, pairing, left_team, right_team, seed, decides, state,
  end_reason, forfeit, left_score, right_score, left_penalties, right_penalties, fault, message,
  settled, cycles, wall_seconds, run_seconds, cycles_per_second, deterministic, mode, started,
  ended, host, load, version, server, folder,
  left_decisions, left_late, left_missed, left_rpc_p50_us, left_rpc_p99_us, left_cpu_seconds,
  right_decisions, right_late, right_missed, right_rpc_p50_us, right_rpc_p99_us, right_cpu_seconds,
  attempts
FROM match ORDER BY number)";

void bind_optional(SQLite::Statement& statement, int place, const std::optional<int>& value) {
  if (value) {
    statement.bind(place, *value);
  } else {
    statement.bind(place);
  }
}

void bind_side(SQLite::Statement& statement, int place, const SideFigures& side) {
  statement.bind(place, side.decisions);
  statement.bind(place + 1, side.late);
  statement.bind(place + 2, side.missed);
  statement.bind(place + 3, side.rpc_p50_us);
  statement.bind(place + 4, side.rpc_p99_us);
  statement.bind(place + 5, side.cpu_seconds);
}

// Values in the order of a SELECT, one after the other.
class Columns {
 public:
  Columns(SQLite::Statement& statement, int first) : statement_(statement), next_(first) {}

  std::string text() { return statement_.getColumn(next_++).getString(); }
  int whole() { return statement_.getColumn(next_++).getInt(); }
  std::int64_t large() { return statement_.getColumn(next_++).getInt64(); }
  double real() { return statement_.getColumn(next_++).getDouble(); }
  std::optional<int> optional() {
    const SQLite::Column column = statement_.getColumn(next_++);
    if (column.isNull()) return std::nullopt;
    return column.getInt();
  }
  SideFigures side() {
    SideFigures side;
    side.decisions = large();
    side.late = large();
    side.missed = large();
    side.rpc_p50_us = real();
    side.rpc_p99_us = real();
    side.cpu_seconds = real();
    return side;
  }

 private:
  SQLite::Statement& statement_;
  int next_;
};

Fixture fixture_in(SQLite::Statement& row) {
  Columns columns(row, 0);
  Fixture fixture;
  fixture.index = columns.whole();
  fixture.round = columns.whole();
  fixture.stage = columns.text();
  fixture.pairing = columns.whole();
  fixture.left = columns.whole();
  fixture.right = columns.whole();
  fixture.seed = static_cast<std::uint64_t>(columns.large());
  fixture.decides = columns.whole() != 0;
  return fixture;
}

Outcome outcome_in(SQLite::Statement& row) {
  Columns columns(row, 9);
  Outcome outcome;
  outcome.end_reason = columns.text();
  outcome.forfeit = columns.whole() != 0;
  outcome.left_score = columns.whole();
  outcome.right_score = columns.whole();
  outcome.left_penalties = columns.optional();
  outcome.right_penalties = columns.optional();
  outcome.fault = soccer::side_named(columns.text());
  outcome.message = columns.text();
  outcome.attempts = columns.whole();
  outcome.cycles = columns.whole();
  outcome.wall_seconds = columns.real();
  outcome.run_seconds = columns.real();
  outcome.cycles_per_second = columns.real();
  outcome.deterministic = columns.whole() != 0;
  outcome.mode = columns.text();
  outcome.started = columns.text();
  outcome.ended = columns.text();
  outcome.host = columns.text();
  outcome.load = columns.real();
  outcome.version = columns.text();
  outcome.server = columns.text();
  outcome.folder = columns.text();
  outcome.left = columns.side();
  outcome.right = columns.side();
  return outcome;
}

void bind_outcome(SQLite::Statement& statement, const Outcome& outcome) {
  statement.bind(3, outcome.end_reason);
  statement.bind(4, outcome.forfeit ? 1 : 0);
  statement.bind(5, outcome.left_score);
  statement.bind(6, outcome.right_score);
  bind_optional(statement, 7, outcome.left_penalties);
  bind_optional(statement, 8, outcome.right_penalties);
  if (outcome.fault) statement.bind(9, side_name(*outcome.fault));
  statement.bind(10, outcome.message);
  statement.bind(11, outcome.attempts);
  statement.bind(12, outcome.cycles);
  statement.bind(13, outcome.wall_seconds);
  statement.bind(14, outcome.run_seconds);
  statement.bind(15, outcome.cycles_per_second);
  statement.bind(16, outcome.deterministic ? 1 : 0);
  statement.bind(17, outcome.mode);
  statement.bind(18, outcome.started);
  statement.bind(19, outcome.ended);
  statement.bind(20, outcome.host);
  statement.bind(21, outcome.load);
  statement.bind(22, outcome.version);
  statement.bind(23, outcome.server);
  statement.bind(24, outcome.folder);
  bind_side(statement, 25, outcome.left);
  bind_side(statement, 31, outcome.right);
}

// Runs `work`; what the library throws becomes an error that names the file.
template <typename Work>
auto guarded(const std::string& file, Work work) -> Result<decltype(work())> {
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return {};
    } else {
      return work();
    }
  } catch (const SQLite::Exception& error) {
    return Error{fmt::format("{}: {}", file, error.what())};
  }
}

}  // namespace

Store::Store(std::unique_ptr<SQLite::Database> database) : database_(std::move(database)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store> Store::open(const std::filesystem::path& file) {
  return guarded(file.string(), [&] {
    auto database = std::make_unique<SQLite::Database>(
        file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kBusyMs);
    database->exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL;");
    const int version = database->execAndGet("PRAGMA user_version").getInt();
    if (version == 0) {
      SQLite::Transaction transaction(*database);
      database->exec(kTables);
      database->exec(fmt::format("PRAGMA user_version = {}", kSchemaVersion));
      transaction.commit();
    } else if (version != kSchemaVersion) {
      throw SQLite::Exception(fmt::format("written by another version of cls (schema {}, not {})",
                                          version, kSchemaVersion));
    }
    return Store(std::move(database));
  });
}

Result<Store> Store::open_to_read(const std::filesystem::path& file) {
  std::error_code code;
  if (!std::filesystem::exists(file, code)) {
    return Error{fmt::format("{}: no such file", file.string())};
  }
  return open(file);  // WAL readers write too: the shared index beside the file
}

Result<std::vector<ScheduledMatch>> Store::matches() const {
  return guarded(database_->getFilename(), [&] {
    std::vector<ScheduledMatch> all;
    SQLite::Statement row(*database_, kSelect);
    while (row.executeStep()) {
      ScheduledMatch match;
      match.fixture = fixture_in(row);
      match.settled = row.getColumn(17).getInt();
      match.attempts = row.getColumn(43).getInt();
      const std::string state = row.getColumn(8).getString();
      if (state == "done" || state == "failed") match.outcome = outcome_in(row);
      all.push_back(std::move(match));
    }
    return all;
  });
}

Result<void> Store::add(std::span<const Fixture> fixtures) {
  return guarded(database_->getFilename(), [&] {
    SQLite::Transaction transaction(*database_);
    SQLite::Statement insert(*database_, kAdd);
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
    SQLite::Statement row(*database_,
                          "SELECT number FROM match WHERE state = 'running' ORDER BY number");
    while (row.executeStep()) numbers.push_back(row.getColumn(0).getInt());
    return numbers;
  });
}

Result<void> Store::put_back(bool failed_too) {
  return guarded(database_->getFilename(), [&] {
    database_->exec(failed_too ? "UPDATE match SET state = 'planned' "
                                 "WHERE state IN ('running', 'failed')"
                               : "UPDATE match SET state = 'planned' WHERE state = 'running'");
  });
}

Result<void> Store::finish(int index, const Outcome& outcome, bool final) {
  return guarded(database_->getFilename(), [&] {
    SQLite::Statement update(*database_, kFinish);
    update.bind(1, index);
    update.bind(2, final ? "done" : "failed");
    bind_outcome(update, outcome);
    update.exec();
  });
}

}  // namespace cls::orchestration::tournament
