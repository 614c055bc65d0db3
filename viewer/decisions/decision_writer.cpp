// Blocks of decisions: columns, then texts.
#include "viewer/decisions/decision_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.h"
#include "base/system/version.h"
#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::viewer {
namespace {

using base::Json;
using Slots = std::array<UnnumberedPlayer, kUnnumberedSlots>;

std::int64_t scaled(double value, const DecisionColumnSpec& column) {
  const double real = value * column.scale;
  if (!(std::abs(real) <= static_cast<double>(kMaxScaled))) return 0;
  const std::int64_t integer = std::llround(real);
  return column.coding == Coding::kAngle ? wrapped(integer, 180 * column.scale) : integer;
}

Integers integers_of(const std::vector<SlottedSample>& samples, const DecisionColumnSpec& column) {
  Integers integers;
  integers.reserve(samples.size() * column.series);
  for (std::size_t series = 0; series < column.series; ++series) {
    for (const SlottedSample& sample : samples) {
      integers.push_back(scaled(column.load(sample, series), column));
    }
  }
  return integers;
}

/// Gives each player the slot that it had, or a free one. A free slot keeps its last numbers, so
/// that they cost nothing.
void assign_slots(const std::vector<UnnumberedPlayer>& players, Slots& slots) {
  const auto slot_of_id = [&](int id) {
    return std::ranges::find(slots, id, &UnnumberedPlayer::id);
  };

  for (UnnumberedPlayer& slot : slots) {
    const auto tracked = std::ranges::find(players, slot.id, &UnnumberedPlayer::id);
    if (tracked == players.end()) slot.id = 0;
  }

  for (const UnnumberedPlayer& player : players) {
    auto slot = slot_of_id(player.id);
    if (slot == slots.end()) slot = slot_of_id(0);
    if (slot != slots.end()) *slot = player;
  }
}

/// Players that are not known keep their last numbers, too.
void keep_last_numbers(const DecisionSample& last, DecisionSample& sample) {
  for (std::size_t i = 0; i < sample.players.size(); ++i) {
    EstimatedPlayer& player = sample.players[i];
    if (player.age == kUnknownAge) player.position = last.players[i].position;
  }
}

/// Player and number of decisions.
std::string block_start(int unum, std::size_t count) {
  std::string contents;
  append_varint(static_cast<std::uint64_t>(unum), contents);
  append_varint(count, contents);
  return contents;
}

Json columns_json() {
  Json rows = Json::array();
  for (const DecisionColumnSpec& column : decision_columns()) {
    Json row = {{"name", column.name}, {"coding", name(column.coding)}, {"series", column.series}};
    if (column.scale != 1) row["scale"] = column.scale;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<ColumnState> decision_states() {
  std::vector<ColumnState> states;
  for (const DecisionColumnSpec& column : decision_columns()) states.emplace_back(column.series);
  return states;
}

DecisionWriter::Player& DecisionWriter::player_of(int unum) {
  return players_.at(base::index(unum - 1));
}

void DecisionWriter::append(ChunkKind kind, std::string_view contents, std::string& out) {
  const std::size_t start = out.size();
  append_chunk(kind, contents, out);
  if (kind != ChunkKind::kLatency) add_to_checksum(std::string_view(out).substr(start), checksum_);
}

void DecisionWriter::append_header(soccer::Side side, std::string_view team, std::string& out) {
  const Json header = {{"schema", kDecisionsSchema},
                       {"cls", base::kVersion},
                       {"side", soccer::side_name(side)},
                       {"team", team},
                       {"columns", columns_json()}};
  append(ChunkKind::kHeader, base::json_line(header), out);
}

void DecisionWriter::append(int unum, const DecisionSample& sample, std::string& out) {
  Player& player = player_of(unum);
  assign_slots(sample.unnumbered, player.unnumbered);
  SlottedSample slotted{sample, player.unnumbered};
  keep_last_numbers(player.samples.empty() ? player.last : player.samples.back().sample,
                    slotted.sample);

  player.samples.push_back(std::move(slotted));
  ++decisions_;
  if (player.samples.size() == kDecisionBlock) append_blocks(out);
}

std::string DecisionWriter::numbers_of(int unum) {
  Player& player = player_of(unum);
  std::string contents = block_start(unum, player.samples.size());
  std::size_t index = 0;
  for (const DecisionColumnSpec& column : decision_columns()) {
    const CodingInput input{column.coding, std::int64_t{180} * column.scale, nullptr};
    encode_column(input, integers_of(player.samples, column), player.states[index++], contents);
  }
  return contents;
}

std::string DecisionWriter::texts_of(int unum, std::size_t kind) {
  Player& player = player_of(unum);
  std::vector<std::string_view> texts;
  for (const SlottedSample& row : player.samples) {
    texts.emplace_back(row.sample.*kDecisionTexts.at(kind));
  }

  std::string contents = block_start(unum, texts.size());
  append_varint(kind, contents);
  encode_texts(texts, player.shapes.at(kind), contents);
  return contents;
}

std::string DecisionWriter::latencies_of(int unum) {
  Player& player = player_of(unum);
  std::string contents = block_start(unum, player.samples.size());
  for (const SlottedSample& row : player.samples) {
    const std::int64_t latency = std::clamp<std::int64_t>(row.sample.latency_us, 0, kMaxInteger);
    append_zigzag(latency - player.last_latency, contents);
    player.last_latency = latency;
  }
  return contents;
}

void DecisionWriter::append_blocks(std::string& out) {
  std::vector<int> unums;
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    if (!player_of(unum).samples.empty()) unums.push_back(unum);
  }

  for (const int unum : unums) append(ChunkKind::kDecisions, numbers_of(unum), out);
  for (std::size_t kind = 0; kind < kDecisionTexts.size(); ++kind) {
    for (const int unum : unums) append(ChunkKind::kTexts, texts_of(unum, kind), out);
  }
  for (const int unum : unums) append(ChunkKind::kLatency, latencies_of(unum), out);

  for (const int unum : unums) {
    Player& player = player_of(unum);
    player.last = std::move(player.samples.back().sample);
    player.samples.clear();
  }
}

void DecisionWriter::append_end(std::string& out) {
  append_blocks(out);
  const Json end = {{"decisions", decisions_}, {"crc32", checksum_text(checksum_)}};
  append(ChunkKind::kEnd, base::json_line(end), out);
}

}  // namespace cls::viewer
