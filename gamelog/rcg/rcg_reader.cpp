// Detects the version of a game log and checks that the log is complete.
#include "gamelog/rcg/rcg_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/io/input_buffer.h"
#include "base/text/number_text.h"
#include "gamelog/rcg/format_readers.h"
#include "gamelog/rcg/json_elements.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {
namespace {

constexpr std::string_view kHeaderStart = "ULG";
constexpr std::size_t kBinaryHeaderSize = 4;

bool has_end(const MatchRecord& record) {
  if (!record.mode.empty() && record.mode.back() == soccer::PlayMode::kTimeOver) return true;
  return std::any_of(record.notes.rbegin(), record.notes.rend(), is_result);
}

void check_end(const base::InputBuffer& input, RecordBuilder& builder) {
  if (!input.source().error().empty()) {
    builder.add_cause(input, input.source().error());
  } else if (builder.record().errors.empty() && !has_end(builder.record())) {
    builder.add_error(input, "no end of the match: the log is incomplete");
  }
}

// The number after "ULG" of a version that this reader does not know: digits and the end of the
// line, or one byte. Nothing for other bytes.
std::optional<int> unknown_version(std::string_view start) {
  if (!start.starts_with(kHeaderStart) || start.size() == kHeaderStart.size()) return std::nullopt;
  std::string_view rest = start.substr(kHeaderStart.size());
  const auto byte = static_cast<unsigned char>(rest.front());
  if (byte < ' ' && byte != '\n' && byte != '\r') return byte;
  int number = 0;
  const std::size_t digits = base::parse_int_prefix(rest, number);
  rest.remove_prefix(digits);
  const bool ends = digits > 0 && (rest.starts_with('\n') || rest.starts_with('\r'));
  return ends ? std::optional(number) : std::nullopt;
}

std::string why_not_read(std::string_view start) {
  if (const auto version = unknown_version(start)) {
    return "game log (rcg) of version " + std::to_string(*version) +
           ", which this cls does not know: it reads 1 to 7 and JSON; a newer cls may read it";
  }
  return "not a game log (rcg)";
}

/// Selects the reader by the first bytes (docs/spec/log-formats.md 1.2). Server 17 wrote JSON after
/// the header of version 6.
void read_by_kind(base::InputBuffer& input, RecordBuilder& builder) {
  MatchRecord& record = builder.record();
  constexpr std::size_t kHeaderSize = 7;
  const std::string start(input.peek(kHeaderSize));

  // A log may have been sent through Windows or a mail: then its lines end with CR LF.
  const std::size_t end = start.find('\n');
  std::string first = start.substr(0, end);
  if (first.ends_with('\r')) first.pop_back();

  const bool has_array = end != std::string::npos && start.substr(end + 1).starts_with('[');
  std::string_view header;

  if (start.starts_with('[') || (has_array && (first == "ULG6" || first == "JSON"))) {
    record.version = RcgVersion::kJson;
    if (!start.starts_with('[')) input.next_line(header);
    if (!has_other_lines(input)) return read_rcg_json(input, builder);
    ElementLines elements(input);
    base::InputBuffer lines(elements);
    read_rcg_json(lines, builder);
  } else if (end != std::string::npos &&
             (first == "ULG4" || first == "ULG5" || first == "ULG6" || first == "ULG7")) {
    record.version = static_cast<RcgVersion>(start[3] - '0');
    record.has_ball_height = record.version == RcgVersion::kV7;
    input.next_line(header);
    read_rcg_text(input, builder);
  } else if (start.starts_with("ULG\x02") || start.starts_with("ULG\x03")) {
    record.version = static_cast<RcgVersion>(start[3]);
    input.take(kBinaryHeaderSize);
    read_rcg_binary(input, builder);
  } else if (looks_like_version_1(start)) {
    record.version = RcgVersion::kV1;
    read_rcg_binary(input, builder);
  } else {
    builder.add_error(input, why_not_read(start));
  }
}

}  // namespace

bool is_result(const Note& note) {
  const auto* message = std::get_if<Message>(&note.content);
  return message != nullptr && message->text.starts_with("(result ");
}

MatchRecord read_rcg(base::ByteSource& source) {
  base::InputBuffer input(source);
  return read_rcg(input);
}

MatchRecord read_rcg(base::InputBuffer& input) {
  MatchRecord record;
  read_rcg(input, record);
  return record;
}

void read_rcg(base::InputBuffer& input, MatchRecord& record) {
  RecordBuilder builder(record);
  read_by_kind(input, builder);
  check_end(input, builder);
}

base::Result<MatchRecord> read_rcg_file(const std::string& path) {
  TRY_INIT(auto source, base::open_source(path));
  return read_rcg(*source);
}

}  // namespace cls::gamelog
