// Chunks of a stream: kind, length, contents (docs/formats/view.md).
#pragma once

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "viewer/stream/bytes.h"

namespace cls::viewer {

constexpr std::string_view kViewSchema = "cls.view/1";

/// Kinds of chunks of matches and of decisions, the letters of the formats.
enum class ChunkKind : char {
  kHeader = 'H',
  kParameters = 'P',
  kNotes = 'N',
  kFrames = 'F',
  kStatistics = 'S',
  kEnd = 'E',
  kDecisions = 'B',  ///< numbers of the decisions of a player
  kTexts = 'W',      ///< their texts of one kind
  kLatency = 'T',    ///< their latencies, which are not the same in each run
};

/// Kinds of notes in a chunk of them: the alternatives of gamelog::Note::content.
enum class NoteKind : std::uint8_t { kMode, kTeams, kMessage, kUnknownLine };

inline void append_chunk(ChunkKind kind, std::string_view contents, std::string& out) {
  out += static_cast<char>(kind);
  append_string(contents, out);
}

/// Continues the CRC-32 of a stream with the next bytes.
inline void add_to_checksum(std::string_view bytes, std::uint32_t& checksum) {
  checksum = static_cast<std::uint32_t>(
      crc32_z(checksum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// The checksum as text at the end of a stream.
inline std::string checksum_text(std::uint32_t checksum) { return fmt::format("{:08x}", checksum); }

}  // namespace cls::viewer
