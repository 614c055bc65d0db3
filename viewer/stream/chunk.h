// Chunks of a stream: kind, length, contents (docs/formats/view.md).
#pragma once

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

}  // namespace cls::viewer
