// Fills the chunks: notes, columns with their exceptions, checksum.
#include "viewer/stream/chunk_writer.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "base/overloaded.h"
#include "base/text/json.h"
#include "base/text/json_text.h"

namespace cls::viewer {
namespace {

using gamelog::MatchRecord;

bool same_bits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

struct Exceptions {
  std::string pairs;
  std::uint64_t count = 0;
  std::size_t next = 0;

  void add(std::size_t entry, float value) {
    append_varint(entry - next, pairs);
    append_float(value, pairs);
    next = entry + 1;
    ++count;
  }
};

// The nearest integer of a value; 0 for one without.
std::int64_t scaled(float value, const StreamColumn& column) {
  if (column.spec->optional && std::isnan(value)) return kNone;
  const double real = static_cast<double>(value) * static_cast<double>(column.scale);
  if (!(std::abs(real) <= static_cast<double>(kMaxScaled))) return 0;
  const std::int64_t integer = std::llround(real);
  return column.coding == Coding::kAngle ? wrapped(integer, 180 * column.scale) : integer;
}

Integers scaled_values(const std::vector<float>& values, const StreamColumn& column,
                       Exceptions* exceptions) {
  Integers integers(values.size());
  const auto scale = static_cast<double>(column.scale);
  for (std::size_t i = 0; i < values.size(); ++i) {
    integers[i] = scaled(values[i], column);
    const float read = integers[i] == kNone
                           ? std::numeric_limits<float>::quiet_NaN()
                           : static_cast<float>(static_cast<double>(integers[i]) / scale);
    if (exceptions != nullptr && !same_bits(read, values[i])) exceptions->add(i, values[i]);
  }
  return integers;
}

void append_note(const gamelog::Note& note, std::string& out) {
  append_varint(note.frame, out);
  append_zigzag(note.time, out);
  append_zigzag(note.stopped, out);

  out += static_cast<char>(note.content.index());  // a NoteKind
  std::visit(
      base::Overloaded{[&](soccer::PlayMode mode) { out += static_cast<char>(mode); },
                       [&](const gamelog::TeamFrames& teams) {
                         for (const gamelog::TeamFrame& team : teams) {
                           append_string(team.name, out);
                           append_zigzag(team.score, out);
                           append_zigzag(team.penalty_scored, out);
                           append_zigzag(team.penalty_missed, out);
                         }
                       },
                       [&](const gamelog::Message& message) {
                         append_zigzag(message.board, out);
                         append_string(message.text, out);
                       },
                       [&](const gamelog::UnknownLine& line) { append_string(line.text, out); }},
      note.content);
}

std::string parameters_of(const MatchRecord& record) {
  std::string contents;
  append_string(record.server_version, contents);
  append_string(record.timestamp, contents);
  append_varint(record.parameter_lines.size(), contents);
  for (const std::string& line : record.parameter_lines) append_string(line, contents);
  return contents;
}

base::Json errors_json(const gamelog::ParseErrors& errors) {
  base::Json first = base::Json::array();
  for (const gamelog::ParseError& error : errors.first) {
    first.push_back({{"line", error.line},
                     {"byte", error.byte},
                     {"cycle", error.cycle},
                     {"message", error.message}});
  }
  return {{"count", errors.count}, {"first", first}};
}

}  // namespace

void ChunkWriter::append(ChunkKind kind, std::string_view contents, std::string& out) {
  const std::size_t start = out.size();
  append_chunk(kind, contents, out);
  add_to_checksum(std::string_view(out).substr(start), checksum_);
}

void ChunkWriter::append_header(const MatchRecord& record, std::string& out) {
  state_.set_header(header_of(record, form_));
  append(ChunkKind::kHeader, header_json(record, state_.header()), out);
  append(ChunkKind::kParameters, parameters_of(record), out);
}

void ChunkWriter::append_notes(const MatchRecord& record, std::size_t before, std::string& out) {
  std::string notes;
  const std::size_t first = notes_;
  for (; notes_ < record.notes.size() && record.notes[notes_].frame < before; ++notes_) {
    append_note(record.notes[notes_], notes);
  }
  if (notes_ == first) return;

  std::string contents;
  append_varint(notes_ - first, contents);
  append(ChunkKind::kNotes, contents + notes, out);
}

void ChunkWriter::append_column(const MatchRecord& record, std::size_t index, std::size_t end,
                                std::string& contents) {
  const StreamColumn& column = state_.header().columns[index];
  const std::size_t first = frames_ * column.series;
  const std::size_t count = (end - frames_) * column.series;

  Integers integers(count);
  Exceptions exceptions;
  if (column.spec->is_real()) {
    std::vector<float> values(count);
    column.spec->load_reals(record, first, count, values.data());
    integers = scaled_values(transposed(values, column.series), column,
                             form_.compact ? nullptr : &exceptions);
  } else {
    column.spec->load_integers(record, first, count, integers.data());
    integers = transposed(integers, column.series);
  }

  const CodingInput input = state_.input(index, end - frames_);
  encode_column(input, integers, state_.state(index), contents);
  state_.keep(index, std::move(integers));

  if (!column.spec->is_real()) return;
  append_varint(exceptions.count, contents);
  contents += exceptions.pairs;
}

void ChunkWriter::append_frames(const MatchRecord& record, std::size_t end, std::string& out) {
  if (end <= frames_) return;
  append_notes(record, end, out);

  std::string contents;
  append_varint(end - frames_, contents);
  state_.begin_frames();
  for (std::size_t i = 0; i < state_.header().columns.size(); ++i) {
    append_column(record, i, end, contents);
  }

  append(ChunkKind::kFrames, contents, out);
  frames_ = end;
}

void ChunkWriter::append_statistics(std::string_view json, std::string& out) {
  append(ChunkKind::kStatistics, json, out);
}

void ChunkWriter::append_end(const MatchRecord& record, std::string& out) {
  append_notes(record, std::numeric_limits<std::size_t>::max(), out);
  const base::Json json = {{"frames", frames_},
                           {"notes", notes_},
                           {"crc32", checksum_text(checksum_)},
                           {"errors", errors_json(record.errors)}};
  append(ChunkKind::kEnd, base::json_line(json), out);
}

std::string write_stream(const MatchRecord& record, StreamForm form, std::string_view statistics) {
  std::string out;
  ChunkWriter writer(form);
  writer.append_header(record, out);
  writer.append_frames(record, record.frames(), out);
  if (!statistics.empty()) writer.append_statistics(statistics, out);
  writer.append_end(record, out);
  return out;
}

}  // namespace cls::viewer
