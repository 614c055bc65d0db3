// Packs matches, lists them.
#include "tournament/dataset/dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/index.h"
#include "base/io/whole_file.h"
#include "match/result/match_folder.h"
#include "match/terms/endpoint.h"
#include "match/terms/match_options.h"
#include "tournament/config/config_file.h"
#include "tournament/dataset/data_card.h"
#include "tournament/store/folder.h"
#include "tournament/store/json_lines.h"
#include "tournament/store/match_document.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/decisions/decision_reader.h"
#include "viewer/page/encoding.h"
#include "viewer/page/page.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

constexpr int kShard = 1000;  // matches
constexpr const char* kRecordKey = "record_world_models";

// "shards/000/000017".
std::string stem_of(const Fixture& fixture) {
  return fmt::format("{}/{:03}/{:06}", kDatasetShards, fixture.index / kShard, fixture.index);
}

Result<DatasetFile> write_packed(const fs::path& dataset, std::string path,
                                 std::string_view bytes) {
  const std::string packed = viewer::gzip(bytes);
  TRY(base::create_folders((dataset / path).parent_path()));
  TRY(base::write_file(dataset / path, packed));
  return DatasetFile{std::move(path), packed.size(), viewer::sha256_hex(packed)};
}

// Latencies differ from run to run.
Result<std::string> world_models(const fs::path& file) {
  const auto packed = base::read_file(file);
  if (!packed) return Error{fmt::format("{}: no such file", file.string())};
  const auto stream = viewer::gunzip(*packed, viewer::kMaxWorldModels);
  auto rest = stream ? viewer::without_latencies(*stream) : stream.error();
  if (!rest) return Error{fmt::format("{}: {}", file.string(), rest.error().message)};
  return rest;
}

Result<std::string> full_state(const fs::path& folder) {
  const fs::path log = match::game_log_in(folder);
  TRY_INIT(const auto match, viewer::read_log_or_page(log.string()));
  if (!match.record.errors.empty()) {
    return Error{gamelog::format_error(log.string(), match.record.errors.first.front())};
  }
  return viewer::write_stream(match.record, viewer::StreamForm{}, "");
}

// Removes what a killed run was writing.
void remove_other_files(const fs::path& folder, const std::vector<DatasetMatch>& matches) {
  std::set<fs::path> known;
  for (const DatasetMatch& match : matches) {
    for (const DatasetFile& file : match.files) known.insert(folder / file.path);
  }

  std::vector<fs::path> others;
  std::error_code code;
  for (fs::recursive_directory_iterator at(folder / kDatasetShards, code), end; !code && at != end;
       at.increment(code)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored) && !known.contains(at->path())) others.push_back(at->path());
  }

  for (const fs::path& other : others) fs::remove(other, code);
}

}  // namespace

DatasetSize size_of(const std::vector<DatasetMatch>& matches) {
  DatasetSize size;
  for (const DatasetMatch& match : matches) {
    size.valid += match.files.empty() ? 0 : 1;
    for (const DatasetFile& file : match.files) size.bytes += file.bytes;
  }
  return size;
}

bool is_dataset(const fs::path& folder) {
  std::error_code code;
  return fs::is_regular_file(folder / kDatasetMatches, code) &&
         fs::is_regular_file(folder / kDatasetPlan, code);
}

TournamentConfig dataset_config(TournamentConfig config) {
  config.conditions.options[kRecordKey] = "true";
  for (const auto& [name, value] : {std::pair("server::game_log_compression", "0"),
                                    std::pair("server::text_logging", "false")}) {
    if (!config.conditions.sets(name)) config.conditions.settings.push_back({name, value});
  }
  return config;
}

Result<DatasetMatch> pack_match(const TournamentConfig& config, const ScheduledMatch& match,
                                const fs::path& folder, const fs::path& dataset) {
  const Outcome& outcome = *match.outcome;
  DatasetMatch packed;
  packed.fixture = match.fixture;
  packed.left = config.competition.team(match.fixture.left);
  packed.right = config.competition.team(match.fixture.right);

  packed.score = {outcome.left_score, outcome.right_score};
  packed.end_reason = name(outcome.end_reason);
  packed.cycles = outcome.cycles;
  packed.deterministic = outcome.deterministic;
  packed.version = outcome.version;
  if (!outcome.finished()) return packed;

  const std::string stem = stem_of(match.fixture);
  TRY_INIT(const auto state, full_state(folder));
  TRY_INIT(auto written, write_packed(dataset, stem + ".view.gz", state));
  packed.files.push_back(std::move(written));
  for (const char* file : {viewer::kLeftWorldModelsFile, viewer::kRightWorldModelsFile}) {
    std::error_code code;
    if (!fs::exists(folder / file, code)) continue;  // a side without agents of cls
    TRY_INIT(const auto models, world_models(folder / file));
    TRY_INIT(auto more, write_packed(dataset, stem + "." + file, models));
    packed.files.push_back(std::move(more));
  }
  return packed;
}

template <typename Codec>
static void members(Codec& codec, typename Codec::template Object<DatasetFile>& file) {
  codec.required("path", file.path);
  codec.required("bytes", file.bytes);
  codec.required("sha256", file.sha256);
}

template <typename Codec>
static void members(Codec& codec, typename Codec::template Object<DatasetMatch>& match) {
  members(codec, match.fixture);
  codec.required("left_team", match.left);
  codec.required("right_team", match.right);
  codec.pair("score", match.score.first, match.score.second);
  codec.required("end_reason", match.end_reason);
  codec.required("cycles", match.cycles);
  codec.required("deterministic", match.deterministic);
  codec.required("version", match.version);
  codec.required("files", match.files);
}

std::string format_dataset_match(const DatasetMatch& match) { return format_json_line(match); }

Result<DatasetMatch> parse_dataset_match(std::string_view line) {
  return parse_json<DatasetMatch>(line);
}

Result<std::vector<DatasetMatch>> read_dataset_matches(const fs::path& folder) {
  const fs::path file = folder / kDatasetMatches;
  std::error_code code;
  if (!fs::exists(file, code)) return Error{fmt::format("{}: no such file", file.string())};
  return read_json_lines<DatasetMatch>(file);
}

Result<fs::path> find_dataset_file(const fs::path& folder, const DatasetFile& file) {
  const fs::path path = file.path;
  const auto problem = [&](std::string_view what) {
    return Error{fmt::format("{}: {}", file.path, what)};
  };
  const bool leaves = std::ranges::find(path, fs::path("..")) != path.end();
  if (path.empty() || path.is_absolute() || leaves) {
    return problem("not a path inside of the data set");
  }

  const fs::path whole = folder / path;
  if (base::absence(whole)) return problem("missing");
  if (const auto why = base::why_no_file(whole)) return problem(*why);

  if (!is_inside(whole, folder)) return problem("a link that leads out of the data set");

  std::error_code code;
  const std::uint64_t bytes = fs::file_size(whole, code);
  if (code) return problem(code.message());
  if (bytes != file.bytes) return problem(fmt::format("{} bytes, not {}", bytes, file.bytes));
  return whole;
}

std::string foreign_part(const TournamentConfig& config, const Fixture& fixture) {
  const match::MatchOptions options = match_options(config.conditions);
  if (options.server_choice.kind != match::ServerChoice::Kind::kEmbedded) {
    return fmt::format("the server is '{}'", options.server_choice.text);
  }
  if (!options.book.empty()) return fmt::format("the book is '{}'", options.book);
  for (const int team : {fixture.left, fixture.right}) {
    const TeamEntry& entry = config.competition.teams[base::index(team)];
    const auto endpoint = match::parse_endpoint(entry.endpoint);
    if (endpoint && endpoint->is_built_in()) continue;
    return fmt::format("{} is '{}'", entry.name, entry.endpoint);
  }
  return {};
}

Result<TournamentConfig> read_dataset_plan(const fs::path& folder) {
  if (holds_plan(folder / kDatasetWork)) return read_plan(folder / kDatasetWork);
  ParsedConfig parsed = read_config(folder / kDatasetPlan);
  if (!parsed.errors.empty()) return Error{parsed.errors.front()};
  if (const auto errors = validate(parsed.config); !errors.empty()) {
    return Error{fmt::format("{}: {}", (folder / kDatasetPlan).string(), errors.front())};
  }
  return std::move(parsed.config);
}

Result<void> write_dataset(const TournamentConfig& config, const std::vector<DatasetMatch>& matches,
                           const fs::path& folder) {
  remove_other_files(folder, matches);
  TRY(base::write_file(folder / kDatasetPlan, format_config(config, true)));
  TRY(base::write_file(folder / kDatasetCard, data_card(config, matches)));
  return write_json_lines(folder / kDatasetMatches, matches);
}

}  // namespace cls::tournament
