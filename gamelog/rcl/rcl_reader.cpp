// Parses text logs line by line.
#include "gamelog/rcl/rcl_reader.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/io/input_buffer.h"
#include "base/text/number_scan.h"
#include "base/text/number_text.h"
#include "soccer/side.h"

namespace cls::gamelog {
namespace {

constexpr std::size_t kMaxText = std::size_t{1} << 30;
constexpr std::size_t kMaxTeams = 200;
constexpr std::string_view kReceived = "Recv ";
constexpr std::string_view kReferee = "(referee ";
constexpr std::string_view kCoach = "Coach";

class RclReader {
 public:
  RclReader(base::InputBuffer& input, RclRecord& record) : input_(input), record_(record) {}

  void read_all() {
    std::string_view line;
    for (;;) {
      const base::InputBuffer::Line kind = input_.next_line(line);
      if (kind == base::InputBuffer::Line::kEnd) break;
      if (kind == base::InputBuffer::Line::kTooLong) {
        add_error("line longer than 1 MiB");
      } else if (!read(line)) {
        return;
      } else if (kind == base::InputBuffer::Line::kUnfinished) {
        add_error("truncated log");
      }
    }

    if (!input_.source().error().empty()) {
      record_.errors.add_cause(error_here(input_.source().error()));
    } else if (record_.lines.empty()) {
      add_error("the log is empty");
    }
  }

 private:
  // False if the rest of the log cannot be read.
  bool read(std::string_view line) {
    if (record_.text.size() + line.size() > kMaxText) {
      add_error("more than 1 GiB of text; the rest is ignored");
      return false;
    }

    RclLine entry;
    const char* at = line.data();

    if (!read_stamp(at, entry)) return continuation(line);
    read_text(line.substr(static_cast<std::size_t>(at - line.data())), entry);
    return true;
  }

  // `time,stopped` and a tab, or only the time before server version 13.
  static bool read_stamp(const char*& at, RclLine& entry) {
    if (*at < '0' || *at > '9' || !base::scan_integer(at, entry.time)) return false;

    if (*at == ',') {
      ++at;
      if (*at < '0' || *at > '9' || !base::scan_integer(at, entry.stopped)) return false;
    }

    return *at++ == '\t';
  }

  // Appends to the last line, because a datagram may contain line feeds.
  bool continuation(std::string_view line) {
    if (record_.lines.empty()) {
      add_error("not a text log (rcl)");
      return false;
    }

    record_.text += '\n';
    record_.text += line;
    record_.lines.back().length += static_cast<std::uint32_t>(line.size() + 1);
    return true;
  }

  void read_text(std::string_view text, RclLine& entry) {
    if (text.starts_with(kReceived)) {
      const std::size_t colon = text.find(": ", kReceived.size());
      if (colon != std::string_view::npos &&
          read_sender(text.substr(kReceived.size(), colon - kReceived.size()), entry)) {
        text.remove_prefix(colon + 2);
      }
    } else if (text.starts_with(kReferee) && text.ends_with(')')) {
      entry.source = RclSource::kReferee;
      text = text.substr(kReferee.size(), text.size() - kReferee.size() - 1);
    }

    entry.offset = static_cast<std::uint32_t>(record_.text.size());
    entry.length = static_cast<std::uint32_t>(text.size());
    record_.text += text;
    record_.lines.push_back(entry);
  }

  // Splits at the last underscore: names contain no spaces but may contain underscores and colons.
  bool read_sender(std::string_view sender, RclLine& entry) {
    if (sender == kCoach) {
      entry.source = RclSource::kTrainer;
      return true;
    }

    const std::size_t cut = sender.rfind('_');
    if (cut == std::string_view::npos || cut == 0) return false;

    const std::string_view role = sender.substr(cut + 1);
    const std::optional<int> unum = base::parse_int(role);
    const bool player = unum && soccer::is_unum(*unum);
    if (!player && role != kCoach) return false;

    const std::optional<std::uint8_t> team = team_index(sender.substr(0, cut));
    if (!team) return false;

    entry.team = *team;
    entry.source = player ? RclSource::kPlayer : RclSource::kCoach;
    entry.unum = static_cast<std::uint8_t>(player ? *unum : 0);
    return true;
  }

  std::optional<std::uint8_t> team_index(std::string_view name) {
    auto found = std::ranges::find(record_.teams, name);
    if (found == record_.teams.end()) {
      if (record_.teams.size() == kMaxTeams) return std::nullopt;
      found = record_.teams.emplace(found, name);
    }
    return static_cast<std::uint8_t>(found - record_.teams.begin());
  }

  ParseError error_here(std::string message) const {
    const int cycle = record_.lines.empty() ? 0 : record_.lines.back().time;
    return {input_.line_number(), input_.offset(), cycle, std::move(message)};
  }

  void add_error(std::string message) { record_.errors.add(error_here(std::move(message))); }

  base::InputBuffer& input_;
  RclRecord& record_;
};

}  // namespace

RclRecord read_rcl(base::ByteSource& source) {
  base::InputBuffer input(source);
  return read_rcl(input);
}

RclRecord read_rcl(base::InputBuffer& input) {
  RclRecord record;
  record.text.reserve(
      static_cast<std::size_t>(std::min<std::uint64_t>(input.source().size_hint(), kMaxText)));

  RclReader(input, record).read_all();
  return record;
}

base::Result<RclRecord> read_rcl_file(const std::string& path) {
  TRY_INIT(auto source, base::open_source(path));
  return read_rcl(*source);
}

}  // namespace cls::gamelog
