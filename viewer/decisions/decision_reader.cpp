// Takes chunks of decisions apart.
#include "viewer/decisions/decision_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/text/json_text.h"
#include "base/text/schema.h"
#include "viewer/decisions/decision_columns.h"
#include "viewer/decisions/decision_writer.h"

namespace cls::viewer {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kIncomplete = "incomplete decisions: the match did not end";

struct Chunk {
  char kind = 0;
  std::string_view contents;
  std::string_view bytes;  ///< with kind and length
};

base::Error corrupt(std::string_view why) {
  return base::Error{fmt::format("corrupt decisions: {}", why)};
}

/// The next chunk; nothing at the end or if it is not complete.
std::optional<Chunk> next_chunk(std::string_view& rest) {
  ByteReader reader(rest);
  const auto kind = static_cast<char>(reader.byte());
  const std::string_view contents = reader.string();
  if (!reader.good()) return std::nullopt;

  const std::size_t size = rest.size() - reader.left();
  const Chunk chunk{kind, contents, rest.substr(0, size)};
  rest.remove_prefix(size);
  return chunk;
}

/// The error of a header that this version does not read.
std::optional<base::Error> header_error(const Json& json) {
  if (!json.is_object()) return corrupt("header");
  if (auto error = base::schema_error(json.value("schema", ""), kDecisionsSchema)) {
    return base::Error{*std::move(error)};
  }
  if (!soccer::parse_side(json.value("side", "")) || !json.contains("columns") ||
      !json["columns"].is_array()) {
    return corrupt("header");
  }
  if (json["columns"].size() != decision_columns().size()) return corrupt("other columns");
  return std::nullopt;
}

/// Texts of a team that are longer than this together are not a recording.
constexpr std::size_t kMaxTexts = std::size_t{1} << 28;

class Reader {
 public:
  std::optional<base::Error> read(const Chunk& chunk) {
    if (chunk.kind == kHeaderChunk) return read_header(chunk.contents);
    if (!has_header_) return corrupt("no header");
    if (chunk.kind == kDecisionsChunk) return read_block(chunk.contents);
    if (chunk.kind == kTextsChunk) return read_texts(chunk.contents);
    if (chunk.kind == kLatencyChunk) return read_latencies(chunk.contents);
    return std::nullopt;
  }

  TeamDecisions take() && { return std::move(decisions_); }

 private:
  struct Player {
    DecisionStates states;
    std::array<TextShapes, kDecisionTexts.size()> shapes;
    std::array<std::size_t, kDecisionTexts.size()> texts{};  ///< how many decisions have them
    std::size_t latencies = 0;                               ///< how many decisions have one
    std::int64_t last_latency = 0;
  };

  std::optional<base::Error> read_header(std::string_view contents) {
    const Json json = Json::parse(contents, nullptr, false);
    if (auto error = header_error(json)) return error;

    decisions_.side = *soccer::parse_side(json.value("side", ""));
    decisions_.team = json.value("team", "");
    has_header_ = true;
    return std::nullopt;
  }

  /// Reads the number of the player and the count of decisions; null if they make no sense.
  static int read_start(ByteReader& in, std::size_t& count) {
    const std::uint64_t unum = in.varint();
    count = static_cast<std::size_t>(in.varint());
    const bool good =
        in.good() && unum >= 1 && unum <= soccer::kPlayersPerTeam && count <= kDecisionBlock;
    return good ? static_cast<int>(unum) : 0;
  }

  std::optional<base::Error> read_block(std::string_view contents) {
    ByteReader in(contents);
    std::size_t count = 0;
    const int unum = read_start(in, count);
    if (unum == 0 || count == 0) return corrupt("a chunk of decisions");

    const auto player = static_cast<std::size_t>(unum - 1);
    std::vector<SlottedSample> samples(count);
    std::size_t index = 0;
    for (const DecisionColumnSpec& column : decision_columns()) {
      const CodingInput input{column.coding, std::int64_t{180} * column.scale, nullptr};
      const Integers values = decode_column(input, count, players_[player].states.of(index++), in);
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
      decisions_.players[player].push_back(std::move(slotted.sample));
    }

    return std::nullopt;
  }

  std::optional<base::Error> read_texts(std::string_view contents) {
    ByteReader in(contents);
    std::size_t count = 0;
    const int unum = read_start(in, count);
    const auto kind = static_cast<std::size_t>(in.varint());
    if (unum == 0 || kind >= kDecisionTexts.size()) return corrupt("texts");

    Player& player = players_[static_cast<std::size_t>(unum - 1)];
    std::size_t& first = player.texts[kind];
    std::vector<DecisionSample>& samples = decisions_.players[static_cast<std::size_t>(unum - 1)];
    if (first + count > samples.size()) return corrupt("texts");

    std::vector<std::string> texts = decode_texts(count, player.shapes[kind], room_, in);
    if (!in.good() || !in.at_end()) return corrupt("texts");
    for (std::string& text : texts) {
      room_ -= std::min(room_, text.size());
      samples[first++].*kDecisionTexts[kind] = std::move(text);
    }
    return std::nullopt;
  }

  std::optional<base::Error> read_latencies(std::string_view contents) {
    ByteReader in(contents);
    std::size_t count = 0;
    const int unum = read_start(in, count);
    if (unum == 0) return corrupt("latencies");

    Player& player = players_[static_cast<std::size_t>(unum - 1)];
    std::vector<DecisionSample>& samples = decisions_.players[static_cast<std::size_t>(unum - 1)];
    if (player.latencies + count > samples.size()) return corrupt("latencies");

    for (std::size_t i = 0; i < count; ++i) {
      player.last_latency += in.zigzag();
      samples[player.latencies++].latency_us = player.last_latency;
    }
    if (!in.good()) return corrupt("latencies");
    return std::nullopt;
  }

  TeamDecisions decisions_;
  std::array<Player, soccer::kPlayersPerTeam> players_;
  std::size_t room_ = kMaxTexts;
  bool has_header_ = false;
};

/// Checks the end against the checksum of the chunks before it.
bool matches(std::string_view end, std::uint32_t checksum) {
  const Json json = Json::parse(end, nullptr, false);
  return json.is_object() && json.value("crc32", "") == checksum_text(checksum);
}

}  // namespace

base::Result<TeamDecisions> read_decisions(std::string_view stream) {
  Reader reader;
  std::uint32_t checksum = 0;
  while (const auto chunk = next_chunk(stream)) {
    if (chunk->kind == kEndChunk) {
      if (!matches(chunk->contents, checksum)) return corrupt("the checksum differs");
      return std::move(reader).take();
    }
    if (auto error = reader.read(*chunk)) return *error;
    if (chunk->kind != kLatencyChunk) add_to_checksum(chunk->bytes, checksum);
  }
  return base::Error{kIncomplete};
}

base::Result<std::string> select_players(std::string_view stream, const std::vector<int>& unums) {
  std::string selected;
  std::uint32_t checksum = 0;
  while (const auto chunk = next_chunk(stream)) {
    if (chunk->kind == kEndChunk) {
      Json end = Json::parse(chunk->contents, nullptr, false);
      if (!end.is_object()) return corrupt("the end");
      end["crc32"] = checksum_text(checksum);
      selected += kEndChunk;
      append_string(base::json_line(end), selected);
      return selected;
    }

    if (chunk->kind == kHeaderChunk) {
      if (auto error = header_error(Json::parse(chunk->contents, nullptr, false))) return *error;
    } else {
      ByteReader in(chunk->contents);
      const auto unum = static_cast<int>(in.varint());
      const bool wanted =
          unums.empty() || std::find(unums.begin(), unums.end(), unum) != unums.end();
      if (!wanted) continue;
    }

    selected += chunk->bytes;
    if (chunk->kind != kLatencyChunk) add_to_checksum(chunk->bytes, checksum);
  }
  return base::Error{kIncomplete};
}

base::Result<std::string> without_latencies(std::string_view stream) {
  std::string rest;
  while (const auto chunk = next_chunk(stream)) {
    if (chunk->kind != kLatencyChunk) rest += chunk->bytes;
    if (chunk->kind == kEndChunk) return rest;
  }
  return base::Error{kIncomplete};
}

}  // namespace cls::viewer
