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

/// Kinds of chunks, the letters of the format.
enum ChunkKind : char {
  kHeaderChunk = 'H',
  kParametersChunk = 'P',
  kNotesChunk = 'N',
  kFramesChunk = 'F',
  kStatisticsChunk = 'S',
  kEndChunk = 'E',
};

/// Kinds of notes in a kNotesChunk.
enum NoteKind : unsigned char { kModeNote, kTeamsNote, kMessageNote, kUnknownLineNote };

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
