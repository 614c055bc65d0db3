// Takes chunks apart; every count is checked against the bytes that are there.
#include "viewer/stream/chunk_reader.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "base/text/json.h"
#include "gamelog/record/record_builder.h"
#include "soccer/messages/parameter_message.h"

namespace cls::viewer {
namespace {

using base::Json;
using gamelog::MatchRecord;

constexpr std::uint64_t kMaxChunk = std::uint64_t{512} << 20;
// Every frame has differences of time, ball and 22 players.
constexpr std::size_t kMinFrameBytes = 32;

std::int32_t read_int32(ByteReader& in) {
  const std::int64_t value = in.zigzag();
  if (value != static_cast<std::int32_t>(value)) in.fail();
  return static_cast<std::int32_t>(value);
}

gamelog::TeamFrames read_teams(ByteReader& in) {
  gamelog::TeamFrames teams;
  for (gamelog::TeamFrame& team : teams) {
    team.name = in.string();
    team.score = read_int32(in);
    team.penalty_scored = read_int32(in);
    team.penalty_missed = read_int32(in);
  }
  return teams;
}

soccer::PlayMode read_mode(ByteReader& in) {
  const int mode = in.byte();
  if (mode < soccer::kPlayModeCount) return static_cast<soccer::PlayMode>(mode);
  in.fail();
  return soccer::PlayMode::kNull;
}

// Fails for a kind that this version does not know, because its length is unknown.
gamelog::Note read_note(ByteReader& in) {
  gamelog::Note note;
  const std::uint64_t frame = in.varint();
  if (frame > gamelog::kMaxFrames) in.fail();
  note.frame = static_cast<std::uint32_t>(frame);
  note.time = read_int32(in);
  note.stopped = read_int32(in);

  switch (static_cast<NoteKind>(in.byte())) {
    case NoteKind::kMode:
      note.content = read_mode(in);
      return note;
    case NoteKind::kTeams:
      note.content = read_teams(in);
      return note;
    case NoteKind::kMessage: {
      const int board = read_int32(in);
      note.content = gamelog::Message{board, std::string(in.string())};
      return note;
    }
    case NoteKind::kUnknownLine:
      note.content = gamelog::UnknownLine{std::string(in.string())};
      return note;
  }

  in.fail();
  return note;
}

// Values of a column that a stream lacks.
void clear_frames(MatchRecord& record, std::size_t first) {
  for (std::size_t i = first; i < record.frames(); ++i) {
    record.time[i] = 0;
    record.stopped[i] = 0;
    record.mode[i] = soccer::PlayMode::kNull;
    record.team_state[i] = 0;
    record.ball_position[i] = {0.0F, 0.0F};
    record.ball_velocity[i] = {0.0F, 0.0F};
    record.ball_height[i] = 0.0F;
  }

  for (std::size_t i = first * gamelog::kSlots; i < record.players.state.size(); ++i) {
    gamelog::clear_player(record.players, i);
  }
}

std::vector<float> reals_of(const Integers& integers, const StreamColumn& column) {
  std::vector<float> values(integers.size());
  const bool optional = column.spec != nullptr && column.spec->optional;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool none = optional && integers[i] == kNone;
    values[i] = none ? std::numeric_limits<float>::quiet_NaN()
                     : static_cast<float>(static_cast<double>(integers[i]) /
                                          static_cast<double>(column.scale));
  }
  return values;
}

void read_exceptions(std::vector<float>& values, ByteReader& in) {
  std::uint64_t entry = 0;
  for (std::uint64_t left = in.varint(); left > 0 && in.good(); --left) {
    entry += in.varint();
    const float value = in.real();
    if (entry < values.size()) {
      values[static_cast<std::size_t>(entry)] = value;
    } else {
      in.fail();
    }
    ++entry;
  }
}

bool in_range(const Integers& integers, std::int64_t min, std::int64_t max) {
  return std::ranges::all_of(integers,
                             [=](std::int64_t value) { return value >= min && value <= max; });
}

gamelog::ParseErrors errors_of(const Json& json) {
  gamelog::ParseErrors errors;
  for (const Json& error : json.value("first", Json::array())) {
    errors.add({error.value("line", std::uint64_t{0}), error.value("byte", std::uint64_t{0}),
                error.value("cycle", 0), error.value("message", "")});
  }
  errors.count = std::max(errors.count, json.value("count", std::uint64_t{0}));
  return errors;
}

}  // namespace

base::Result<void> ChunkReader::add(std::string_view bytes) {
  waiting_ += bytes;
  std::string_view rest = waiting_;
  while (error_.empty() && read_chunk(rest)) {
  }
  waiting_.erase(0, waiting_.size() - rest.size());

  if (error_.empty()) return {};
  return base::Error{error_};
}

// False if the chunk is not complete.
bool ChunkReader::read_chunk(std::string_view& rest) {
  constexpr std::size_t kMaxHead = 6;
  ByteReader in(rest);
  const auto kind = static_cast<ChunkKind>(in.byte());
  const std::uint64_t length = in.varint();
  if (!in.good()) {
    if (rest.size() >= kMaxHead) fail("corrupt length of a chunk");
    return false;
  }
  if (length > kMaxChunk) {
    fail("a chunk longer than 512 MiB");
    return false;
  }
  if (in.left() < length) return false;

  const std::string_view contents = in.take(length);
  const std::size_t size = rest.size() - in.left();
  read(kind, contents);
  add_to_checksum(rest.substr(0, size), checksum_);
  rest.remove_prefix(size);

  return error_.empty();
}

void ChunkReader::read(ChunkKind kind, std::string_view contents) {
  if (match_.ended) return fail("a chunk after the end");
  if (kind != ChunkKind::kHeader && !has_header_) return fail("no header: not a match of cls");

  switch (kind) {
    case ChunkKind::kHeader:
      return read_header(contents);
    case ChunkKind::kParameters:
      return read_parameters(contents);
    case ChunkKind::kNotes:
      return read_notes(contents);
    case ChunkKind::kFrames:
      return read_frames(contents);
    case ChunkKind::kStatistics:
      match_.statistics = contents;
      return;
    case ChunkKind::kEnd:
      return read_end(contents);
    default:
      return;
  }
}

void ChunkReader::read_header(std::string_view contents) {
  auto header = parse_header(contents);
  if (!header) return fail(header.error().message);

  match_.record.version = header->version;
  match_.form = header->form;
  for (const StreamColumn& column : header->columns) {
    if (column.spec != nullptr && column.spec->of_height) match_.record.has_ball_height = true;
  }
  state_.set_header(*std::move(header));
  has_header_ = true;
}

void ChunkReader::read_parameters(std::string_view contents) {
  ByteReader in(contents);
  MatchRecord& record = match_.record;
  gamelog::RecordBuilder builder(record);

  record.server_version = in.string();
  record.timestamp = in.string();
  record.parameter_lines.clear();

  for (std::uint64_t left = in.varint(); left > 0 && in.good(); --left) {
    const std::string_view line = in.string();
    // Only lines without errors were stored; of a corrupt stream, the readable values count.
    if (line.starts_with("(server_param ")) std::ignore = soccer::parse(line, record.server);
    if (line.starts_with("(player_param ")) std::ignore = soccer::parse(line, record.player);
    if (line.starts_with("(player_type ")) {
      soccer::PlayerType type;
      type.id = -1;
      std::ignore = soccer::parse(line, type);
      builder.set_player_type(type);
    }
    builder.add_parameter_line(std::string(line));
  }

  if (!in.good()) fail("corrupt parameters");
}

void ChunkReader::read_notes(std::string_view contents) {
  ByteReader in(contents);
  MatchRecord& record = match_.record;
  for (std::uint64_t left = in.varint(); left > 0 && in.good(); --left) {
    gamelog::Note note = read_note(in);
    if (!in.good()) break;
    if (!record.notes.empty() && note.frame < record.notes.back().frame) {
      return fail("corrupt note");
    }

    if (const auto* teams = std::get_if<gamelog::TeamFrames>(&note.content)) {
      record.teams.push_back(*teams);
    }
    record.notes.push_back(std::move(note));
    note_bytes_ += sizeof(gamelog::Note);
  }

  note_bytes_ += contents.size();
  if (note_bytes_ > gamelog::kMaxNoteBytes) return fail(gamelog::kTooManyRecords);
  if (!in.good()) fail("corrupt note");
}

void ChunkReader::read_frames(std::string_view contents) {
  ByteReader in(contents);
  const std::uint64_t count = in.varint();
  const std::size_t first = match_.record.frames();
  if (count > in.left() / kMinFrameBytes) return fail("corrupt frames");
  if (first + count > gamelog::kMaxFrames) return fail(gamelog::kTooManyRecords);

  const auto frames = static_cast<std::size_t>(count);
  gamelog::resize_frames(match_.record, first + frames);
  clear_frames(match_.record, first);
  state_.begin_frames();

  const std::size_t columns = state_.header().columns.size();
  for (std::size_t i = 0; i < columns && in.good() && frames > 0; ++i) {
    read_column(i, first, frames, in);
  }

  if (in.good() && in.at_end()) return;
  gamelog::resize_frames(match_.record, first);
  fail("corrupt frames");
}

void ChunkReader::read_column(std::size_t index, std::size_t first, std::size_t frames,
                              ByteReader& in) {
  const StreamColumn& column = state_.header().columns[index];
  MatchRecord& record = match_.record;
  const CodingInput input = state_.input(index, frames);
  Integers integers = decode_column(input, frames, state_.state(index), in);

  const std::size_t entry = first * column.series;
  if (column.scale != 0) {
    std::vector<float> values = reals_of(integers, column);
    read_exceptions(values, in);
    if (in.good() && column.spec != nullptr) {
      column.spec->store_reals(record, entry, values.size(), transposed(values, frames).data());
    }
  } else if (column.spec != nullptr) {
    const bool teams = column.spec->name == "teams";
    const auto last_teams = static_cast<std::int64_t>(record.teams.size()) - 1;
    const std::int64_t max = teams ? last_teams : column.spec->max;
    if (!in_range(integers, column.spec->min, max)) return in.fail();
    column.spec->store_integers(record, entry, integers.size(),
                                transposed(integers, frames).data());
  }

  state_.keep(index, std::move(integers));
}

void ChunkReader::read_end(std::string_view contents) {
  const Json json = Json::parse_or_discarded(contents);
  try {
    if (json.value("crc32", "") != checksum_text(checksum_)) {
      return fail("wrong checksum: the match is corrupt");
    }
    if (json.value("frames", std::size_t{0}) != match_.record.frames() ||
        json.value("notes", std::size_t{0}) != match_.record.notes.size()) {
      return fail("frames or notes are missing");
    }
    match_.record.errors = errors_of(json.value("errors", Json::object()));
  } catch (const Json::exception&) {
    return fail("corrupt end of the match");
  }

  const auto& notes = match_.record.notes;
  if (!notes.empty() && notes.back().frame > match_.record.frames()) return fail("corrupt note");
  match_.ended = true;
}

void ChunkReader::fail(std::string message) { error_ = std::move(message); }

base::Result<StreamMatch> read_stream(std::string_view bytes) {
  ChunkReader reader;
  TRY(reader.add(bytes));
  if (!reader.match().ended) return base::Error{"truncated: the match has no end"};
  return std::move(reader).take();
}

}  // namespace cls::viewer
