// Packs matches, lists them.
#include "tournament/dataset/dataset.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/io/whole_file.h"
#include "base/text/json_text.h"
#include "tournament/config/config_file.h"
#include "tournament/dataset/data_card.h"
#include "tournament/store/folder.h"
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
using Json = nlohmann::ordered_json;

constexpr const char* kGameLog = "match.rcg";
constexpr int kShard = 1000;  // matches
constexpr std::size_t kMaxWorldModels = std::size_t{1} << 30;
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
  const auto stream = viewer::gunzip(*packed, kMaxWorldModels);
  auto rest = stream ? viewer::without_latencies(*stream) : stream.error();
  if (!rest) return Error{fmt::format("{}: {}", file.string(), rest.error().message)};
  return rest;
}

Result<std::string> full_state(const fs::path& folder) {
  fs::path log = folder / kGameLog;
  std::error_code code;
  if (!fs::exists(log, code)) log += ".gz";
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
    if (at->is_regular_file() && !known.contains(at->path())) others.push_back(at->path());
  }
  for (const fs::path& other : others) fs::remove(other, code);
}

bool is_set(const TournamentConfig& config, std::string_view setting) {
  return std::any_of(config.settings.begin(), config.settings.end(),
                     [setting](const ServerSetting& one) { return one.name == setting; });
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
  config.options[kRecordKey] = "true";
  for (const auto& [name, value] : {std::pair("server::game_log_compression", "0"),
                                    std::pair("server::text_logging", "false")}) {
    if (!is_set(config, name)) config.settings.push_back({name, value});
  }
  return config;
}

Result<DatasetMatch> pack_match(const TournamentConfig& config, const ScheduledMatch& match,
                                const fs::path& folder, const fs::path& dataset) {
  const Outcome& outcome = *match.outcome;
  DatasetMatch packed;
  packed.fixture = match.fixture;
  packed.left = config.teams[static_cast<std::size_t>(match.fixture.left)].name;
  packed.right = config.teams[static_cast<std::size_t>(match.fixture.right)].name;
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

std::string format_dataset_match(const DatasetMatch& match) {
  Json json = Json::parse(format_fixture(match.fixture));
  json["left_team"] = match.left;
  json["right_team"] = match.right;
  json["score"] = {match.score.first, match.score.second};
  json["end_reason"] = match.end_reason;
  json["cycles"] = match.cycles;
  json["deterministic"] = match.deterministic;
  json["version"] = match.version;
  json["files"] = Json::array();
  for (const DatasetFile& file : match.files) {
    json["files"].push_back({{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  return base::json_line(json) + "\n";
}

Result<DatasetMatch> parse_dataset_match(std::string_view line) {
  TRY_INIT(auto fixture, parse_fixture(line));
  DatasetMatch match;
  match.fixture = std::move(fixture);
  try {
    const Json json = Json::parse(line);
    match.left = json.at("left_team").get<std::string>();
    match.right = json.at("right_team").get<std::string>();
    match.score = {json.at("score").at(0).get<int>(), json.at("score").at(1).get<int>()};
    match.end_reason = json.at("end_reason").get<std::string>();
    match.cycles = json.at("cycles").get<int>();
    match.deterministic = json.at("deterministic").get<bool>();
    match.version = json.at("version").get<std::string>();
    for (const Json& file : json.at("files")) {
      match.files.push_back({file.at("path").get<std::string>(),
                             file.at("bytes").get<std::uint64_t>(),
                             file.at("sha256").get<std::string>()});
    }
  } catch (const Json::exception& exception) {
    return Error{exception.what()};
  }
  return match;
}

Result<std::vector<DatasetMatch>> read_dataset_matches(const fs::path& folder) {
  const fs::path file = folder / kDatasetMatches;
  const auto text = base::read_file(file);
  if (!text) return Error{fmt::format("{}: no such file", file.string())};
  std::vector<DatasetMatch> matches;
  for (std::size_t at = 0; at < text->size();) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    auto match = parse_dataset_match(std::string_view(*text).substr(at, end - at));
    if (!match) {
      return Error{
          fmt::format("{}:{}: {}", file.string(), matches.size() + 1, match.error().message)};
    }
    matches.push_back(*std::move(match));
    at = end + 1;
  }
  return matches;
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
  std::string lines;
  for (const DatasetMatch& match : matches) lines += format_dataset_match(match);
  TRY(base::write_file(folder / kDatasetPlan, format_config(config, true)));
  TRY(base::write_file(folder / kDatasetCard, data_card(config, matches)));
  return base::write_file_durably(folder / kDatasetMatches, lines);
}

}  // namespace cls::tournament
