// Writes and reads the header.
#include "viewer/stream/stream_header.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/index.h"
#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/schema.h"
#include "soccer/play_mode.h"
#include "viewer/stream/chunk.h"
#include "viewer/stream/column_codec.h"

namespace cls::viewer {
namespace {

using base::Json;
using gamelog::MatchRecord;
using gamelog::RcgVersion;

constexpr std::int64_t kDefaultDecay = 4000;  // of types that the log lacks
constexpr std::size_t kMaxColumns = 256;
constexpr std::int64_t kMaxScale = 1'000'000;

std::int64_t decay_integer(double decay) {
  return decay >= 0.0 && decay <= 1.0 ? std::llround(decay * kDecayUnit) : kDefaultDecay;
}

// Numbers and booleans by name; texts are in the parameter lines.
template <typename Params>
Json numbers_json(const Params& params, const soccer::ParameterTable<Params>& table) {
  Json json = Json::object();
  for (const auto& row : table) {
    std::visit(
        [&](auto member) {
          using Value = std::decay_t<decltype(params.*member)>;
          if constexpr (!std::is_same_v<Value, std::string>) json[row.name] = params.*member;
        },
        row.member);
  }
  return json;
}

Json types_json(const MatchRecord& record) {
  Json list = Json::array();
  for (const soccer::PlayerType& type : record.types) {
    list.push_back(numbers_json(type, soccer::player_type_table()));
  }
  return list;
}

Json modes_json() {
  Json list = Json::array();
  for (int mode = 0; mode < soccer::kPlayModeCount; ++mode) {
    list.push_back(soccer::name(static_cast<soccer::PlayMode>(mode)));
  }
  return list;
}

Json columns_json(const StreamHeader& header) {
  Json list = Json::array();
  for (const StreamColumn& column : header.columns) {
    Json json = {
        {"name", column.spec->name}, {"coding", name(column.coding)}, {"series", column.series}};
    if (column.scale != 0) json["scale"] = column.scale;
    if (column.spec->optional) json["none"] = kNone;
    if (column.coding == Coding::kVelocity) json["of"] = column.spec->of;
    list.push_back(std::move(json));
  }
  return list;
}

bool is_exact(float value, int scale) {
  const double integer = std::round(static_cast<double>(value) * scale);
  return static_cast<float>(integer / scale) == value;
}

// The coarsest scale that loses nothing of what the usual one keeps: angles of necks are often
// whole degrees.
std::int64_t coarsest_scale(const std::vector<float>& values, int usual) {
  int scale = 1;
  for (const float value : values) {
    if (scale == usual) break;
    if (is_exact(value, scale) || !is_exact(value, usual)) continue;
    while (!is_exact(value, scale)) scale *= 10;
  }
  return scale;
}

bool changes_often(const std::vector<float>& values, std::size_t series) {
  std::size_t changes = 0;
  for (std::size_t i = series; i < values.size(); ++i) changes += values[i] != values[i - series];
  return 2 * changes > values.size();
}

// Fits a column of a whole match to its values. Columns of positions and velocities predict each
// other and keep their form.
void fit(const MatchRecord& record, StreamColumn& column) {
  const ColumnSpec& spec = *column.spec;
  if (spec.coding == Coding::kSecond || spec.coding == Coding::kVelocity) return;

  std::vector<float> values(record.frames() * spec.series);
  spec.load_reals(record, 0, values.size(), values.data());
  column.scale = coarsest_scale(values, spec.scale);

  const bool may_change = spec.coding == Coding::kChanges && !spec.optional;
  if (may_change && changes_often(values, spec.series)) column.coding = Coding::kFirst;
}

std::string version_text(RcgVersion version) {
  return version == RcgVersion::kJson ? "json" : std::to_string(static_cast<int>(version));
}

// Velocities need the integers of positions, those of players also the player types.
bool link_columns(const std::vector<std::string>& names, const std::vector<std::string>& of,
                  StreamHeader& header) {
  std::vector<StreamColumn>& columns = header.columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].coding != Coding::kVelocity) continue;

    // The position of an earlier column with as many series; its integers are kept.
    const auto link = [&](const std::string& name, std::size_t& position) {
      const auto earlier = std::span(names).first(i);
      position = base::index(std::ranges::find(earlier, name) - earlier.begin());
      if (position == i) return false;
      columns[position].keeps_integers = true;
      return columns[position].series == columns[i].series;
    };

    if (!link(of[i], columns[i].of)) return false;
    if (columns[i].series > 1 && !link("type", header.type)) return false;
  }
  return true;
}

bool parse_column(const Json& json, StreamColumn& column) {
  if (!json.is_object()) return false;
  const auto coding = parse_coding(json.value("coding", ""));
  if (!coding) return false;

  column.coding = *coding;
  column.series = json.value("series", std::size_t{0});
  column.scale = json.value("scale", std::int64_t{0});
  if (column.series != 1 && column.series != gamelog::kSlots) return false;
  if (column.scale < 0 || column.scale > kMaxScale) return false;
  if (column.coding == Coding::kAngle && column.scale == 0) return false;

  const ColumnSpec* spec = find_column(json.value("name", ""));
  const bool fits =
      spec != nullptr && spec->series == column.series && spec->is_real() == (column.scale != 0);
  column.spec = fits ? spec : nullptr;
  return true;
}

bool parse_columns(const Json& list, StreamHeader& header) {
  if (!list.is_array() || list.size() > kMaxColumns) return false;

  std::vector<std::string> names;
  std::vector<std::string> of;
  for (const Json& json : list) {
    if (!parse_column(json, header.columns.emplace_back())) return false;
    names.push_back(json.value("name", ""));
    of.push_back(json.value("of", ""));
    if (std::ranges::count(names, names.back()) > 1) return false;
  }

  return link_columns(names, of, header);
}

bool parse_decays(const Json& json, Decays& decays) {
  const auto in_range = [](std::int64_t decay) { return decay >= 0 && decay <= kDecayUnit; };
  decays.ball = json.value("ball_decay", decays.ball);
  const Json types = json.value("type_decay", Json::array());
  if (!in_range(decays.ball) || !types.is_array()) return false;

  for (const Json& decay : types) decays.by_type.push_back(decay.get<std::int64_t>());
  return std::ranges::all_of(decays.by_type, in_range);
}

bool parse_version(const std::string& text, RcgVersion& version) {
  for (int number = 1; number <= static_cast<int>(RcgVersion::kJson); ++number) {
    version = static_cast<RcgVersion>(number);
    if (version_text(version) == text) return true;
  }
  return false;
}

}  // namespace

std::int64_t Decays::of_type(std::int64_t type) const {
  const bool known = type >= 0 && type < std::ssize(by_type);
  return known ? by_type[base::index(type)] : kDefaultDecay;
}

StreamHeader header_of(const MatchRecord& record, StreamForm form) {
  StreamHeader header;
  header.version = record.version;
  header.form = form;

  header.decays.ball = decay_integer(record.server.ball_decay);
  for (const soccer::PlayerType& type : record.types) {
    header.decays.by_type.push_back(decay_integer(type.player_decay));
  }

  std::vector<std::string> names;
  std::vector<std::string> of;
  for (const ColumnSpec& spec : column_table()) {
    const int scale = form.compact ? spec.compact_scale : spec.scale;
    if (spec.is_real() && scale == 0) continue;
    if (spec.of_height && !record.has_ball_height) continue;
    header.columns.push_back({&spec, spec.coding, spec.series, scale, 0, false});
    if (spec.is_real() && !form.compact && !form.live) fit(record, header.columns.back());
    names.emplace_back(spec.name);
    of.emplace_back(spec.of);
  }

  link_columns(names, of, header);
  return header;
}

std::string header_json(const MatchRecord& record, const StreamHeader& header) {
  const gamelog::TeamFrames& teams = record.final_teams();
  const auto pair = [&](auto get) { return Json::array({get(teams[0]), get(teams[1])}); };
  const auto penalties = [](const gamelog::TeamFrame& team) {
    return Json::array({team.penalty_scored, team.penalty_missed});
  };

  const Json json = {{"schema", kViewSchema},
                     {"cls", base::kVersion},
                     {"log", version_text(header.version)},
                     {"compact", header.form.compact},
                     {"live", header.form.live},
                     {"names", pair([](const auto& team) { return Json(team.name); })},
                     {"score", pair([](const auto& team) { return Json(team.score); })},
                     {"penalties", pair(penalties)},
                     {"frames", header.form.live ? Json(nullptr) : Json(record.frames())},
                     {"server", numbers_json(record.server, soccer::server_param_table())},
                     {"types", types_json(record)},
                     {"modes", modes_json()},
                     {"ball_decay", header.decays.ball},
                     {"type_decay", header.decays.by_type},
                     {"columns", columns_json(header)}};
  return json.dump();
}

base::Result<StreamHeader> parse_header(std::string_view text) {
  constexpr const char* kCorrupt = "corrupt header of the match";
  try {
    const Json json = Json::parse(text);
    const std::string schema = json.value("schema", "");
    if (auto error = base::schema_error(schema, kViewSchema)) return base::Error{*std::move(error)};

    StreamHeader header;
    header.form = {json.value("compact", false), json.value("live", false)};
    if (!parse_version(json.value("log", ""), header.version) ||
        !parse_decays(json, header.decays) ||
        !parse_columns(json.value("columns", Json()), header)) {
      return base::Error{kCorrupt};
    }
    return header;
  } catch (const Json::exception&) {
    return base::Error{kCorrupt};
  }
}

}  // namespace cls::viewer
