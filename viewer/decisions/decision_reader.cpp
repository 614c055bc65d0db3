// Takes chunks of decisions apart.
#include "viewer/decisions/decision_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/index.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/schema.h"
#include "viewer/decisions/decision_columns.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::viewer {
namespace {

using base::Json;

constexpr const char* kIncomplete = "incomplete decisions: the match did not end";

struct Chunk {
  ChunkKind kind = ChunkKind::kEnd;
  std::string_view contents;
  std::string_view bytes;  ///< with kind and length
};

base::Error corrupt(std::string_view why) {
  return base::Error{fmt::format("corrupt decisions: {}", why)};
}

/// The next chunk; nothing at the end or if it is not complete.
std::optional<Chunk> next_chunk(std::string_view& rest) {
  ByteReader reader(rest);
  const auto kind = static_cast<ChunkKind>(reader.byte());
  const std::string_view contents = reader.string();
  if (!reader.good()) return std::nullopt;

  const std::size_t size = rest.size() - reader.left();
  const Chunk chunk{kind, contents, rest.substr(0, size)};
  rest.remove_prefix(size);
  return chunk;
}

/// Fails for a header that this version does not read.
base::Result<void> check_header(const Json& json) {
  if (!json.is_object()) return corrupt("header");
  if (auto error = base::schema_error(json.value("schema", ""), kDecisionsSchema)) {
    return base::Error{*std::move(error)};
  }
  if (!soccer::parse_side(json.value("side", "")) || !json.contains("columns") ||
      !json["columns"].is_array()) {
    return corrupt("header");
  }
  if (json["columns"].size() != decision_columns().size()) return corrupt("other columns");
  return {};
}

/// Texts of a team that are longer than this together are not a recording.
constexpr std::size_t kMaxTexts = std::size_t{1} << 28;

class Reader {
 public:
  base::Result<void> read(const Chunk& chunk) {
    if (chunk.kind != ChunkKind::kHeader && !has_header_) return corrupt("no header");

    switch (chunk.kind) {
      case ChunkKind::kHeader:
        return read_header(chunk.contents);
      case ChunkKind::kDecisions:
        return read_block(chunk.contents);
      case ChunkKind::kTexts:
        return read_texts(chunk.contents);
      case ChunkKind::kLatency:
        return read_latencies(chunk.contents);
      default:
        return {};
    }
  }

  TeamDecisions take() && { return std::move(decisions_); }

 private:
  struct Player {
    std::vector<DecisionSample>* samples = nullptr;
    std::vector<ColumnState> states = decision_states();
    std::array<TextShapes, kDecisionTexts.size()> shapes;
    std::array<std::size_t, kDecisionTexts.size()> texts{};  ///< how many decisions have them
    std::size_t latencies = 0;                               ///< how many decisions have one
    std::int64_t last_latency = 0;
  };

  base::Result<void> read_header(std::string_view contents) {
    const Json json = Json::parse_or_discarded(contents);
    TRY(check_header(json));

    decisions_.side = *soccer::parse_side(json.value("side", ""));
    decisions_.team = json.value("team", "");
    has_header_ = true;
    return {};
  }

  /// Reads the number of the player and the count of decisions; null if they make no sense.
  Player* read_start(ByteReader& in, std::size_t& count) {
    const std::uint64_t unum = in.varint();
    count = static_cast<std::size_t>(in.varint());
    const bool good = in.good() && soccer::is_unum(unum) && count <= kDecisionBlock;
    if (!good) return nullptr;

    Player& player = players_[unum - 1];
    player.samples = &decisions_.players[unum - 1];
    return &player;
  }

  base::Result<void> read_block(std::string_view contents) {
    ByteReader in(contents);
    std::size_t count = 0;
    Player* player = read_start(in, count);
    if (player == nullptr || count == 0) return corrupt("a chunk of decisions");

    std::vector<SlottedSample> samples(count);
    std::size_t index = 0;
    for (const DecisionColumnSpec& column : decision_columns()) {
      const CodingInput input{column.coding, std::int64_t{180} * column.scale, nullptr};
      const Integers values = decode_column(input, count, player->states[index++], in);
      if (!in.good()) return corrupt(fmt::format("column {}", column.name));
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double value = static_cast<double>(values[i]) / column.scale;
        column.store(samples[i % count], i / count, value);
      }
    }
    if (!in.good() || !in.at_end()) return corrupt("a chunk of decisions");

    for (SlottedSample& slotted : samples) {
      for (const UnnumberedPlayer& other : slotted.unnumbered) {
        if (other.id != 0) slotted.sample.unnumbered.push_back(other);
      }
      player->samples->push_back(std::move(slotted.sample));
    }
    return {};
  }

  base::Result<void> read_texts(std::string_view contents) {
    ByteReader in(contents);
    std::size_t count = 0;
    Player* player = read_start(in, count);
    const auto kind = static_cast<std::size_t>(in.varint());
    if (player == nullptr || kind >= kDecisionTexts.size()) return corrupt("texts");

    std::size_t& first = player->texts[kind];
    if (first + count > player->samples->size()) return corrupt("texts");

    std::vector<std::string> texts = decode_texts(count, player->shapes[kind], room_, in);
    if (!in.good() || !in.at_end()) return corrupt("texts");
    for (std::string& text : texts) {
      room_ -= std::min(room_, text.size());
      (*player->samples)[first++].*kDecisionTexts[kind] = std::move(text);
    }
    return {};
  }

  base::Result<void> read_latencies(std::string_view contents) {
    ByteReader in(contents);
    std::size_t count = 0;
    Player* player = read_start(in, count);
    if (player == nullptr || player->latencies + count > player->samples->size()) {
      return corrupt("latencies");
    }

    for (std::size_t i = 0; i < count; ++i) {
      player->last_latency += in.zigzag();
      (*player->samples)[player->latencies++].latency_us = player->last_latency;
    }
    if (!in.good()) return corrupt("latencies");
    return {};
  }

  TeamDecisions decisions_;
  std::array<Player, soccer::kPlayersPerTeam> players_;
  std::size_t room_ = kMaxTexts;
  bool has_header_ = false;
};

/// Checks the end against the checksum of the chunks before it.
bool matches(std::string_view end, std::uint32_t checksum) {
  const Json json = Json::parse_or_discarded(end);
  return json.is_object() && json.value("crc32", "") == checksum_text(checksum);
}

}  // namespace

base::Result<TeamDecisions> read_decisions(std::string_view stream) {
  Reader reader;
  std::uint32_t checksum = 0;
  while (const auto chunk = next_chunk(stream)) {
    if (chunk->kind == ChunkKind::kEnd) {
      if (!matches(chunk->contents, checksum)) return corrupt("the checksum differs");
      return std::move(reader).take();
    }
    TRY(reader.read(*chunk));
    if (chunk->kind != ChunkKind::kLatency) add_to_checksum(chunk->bytes, checksum);
  }
  return base::Error{kIncomplete};
}

base::Result<std::string> select_players(std::string_view stream, const std::vector<int>& unums) {
  std::string selected;
  std::uint32_t checksum = 0;
  while (const auto chunk = next_chunk(stream)) {
    if (chunk->kind == ChunkKind::kEnd) {
      Json end = Json::parse_or_discarded(chunk->contents);
      if (!end.is_object()) return corrupt("the end");
      end["crc32"] = checksum_text(checksum);
      append_chunk(ChunkKind::kEnd, base::json_line(end), selected);
      return selected;
    }

    if (chunk->kind == ChunkKind::kHeader) {
      TRY(check_header(Json::parse_or_discarded(chunk->contents)));
    } else {
      ByteReader in(chunk->contents);
      const auto unum = static_cast<int>(in.varint());
      if (!unums.empty() && std::ranges::find(unums, unum) == unums.end()) continue;
    }

    selected += chunk->bytes;
    if (chunk->kind != ChunkKind::kLatency) add_to_checksum(chunk->bytes, checksum);
  }
  return base::Error{kIncomplete};
}

base::Result<std::string> select_cycles(std::string_view stream,
                                        const std::vector<CycleRange>& ranges) {
  if (ranges.empty()) return std::string(stream);
  TRY_INIT(const auto decisions, read_decisions(stream));

  std::string selected;
  DecisionWriter writer;
  writer.append_header(decisions.side, decisions.team, selected);
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    for (const DecisionSample& sample : decisions.players[base::index(unum - 1)]) {
      const bool wanted = std::ranges::any_of(ranges, [&](const CycleRange& range) {
        return range.first <= sample.cycle && sample.cycle <= range.last;
      });
      if (wanted) writer.append(unum, sample, selected);
    }
  }

  writer.append_end(selected);
  return selected;
}

base::Result<std::string> without_latencies(std::string_view stream) {
  std::string rest;
  while (const auto chunk = next_chunk(stream)) {
    if (chunk->kind != ChunkKind::kLatency) rest += chunk->bytes;
    if (chunk->kind == ChunkKind::kEnd) return rest;
  }
  return base::Error{kIncomplete};
}

}  // namespace cls::viewer
