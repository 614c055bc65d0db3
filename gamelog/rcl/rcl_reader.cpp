// Lines of text logs, taken apart at the places that are safe to cut at.
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
        damage("a line of more than a megabyte");
      } else if (!read(line)) {
        return;
      } else if (kind == base::InputBuffer::Line::kUnfinished) {
        damage("the log is cut off here");
      }
    }
    if (!input_.source().problem().empty()) {
      record_.damage.add_reason(damage_here(input_.source().problem()));
    } else if (record_.lines.empty()) {
      damage("the log is empty");
    }
  }

 private:
  // False when there is no use in going on.
  bool read(std::string_view line) {
    if (record_.text.size() + line.size() > kMaxText) {
      damage("more text than any match has: the rest is left out");
      return false;
    }
    RclLine entry;
    const char* at = line.data();
    if (!read_stamp(at, entry)) return continuation(line);
    read_text(line.substr(static_cast<std::size_t>(at - line.data())), entry);
    return true;
  }

  // `time,stopped` and a tab; before server 13 the time alone.
  static bool read_stamp(const char*& at, RclLine& entry) {
    if (*at < '0' || *at > '9' || !base::scan_integer(at, entry.time)) return false;
    if (*at == ',') {
      ++at;
      if (*at < '0' || *at > '9' || !base::scan_integer(at, entry.stopped)) return false;
    }
    return *at++ == '\t';
  }

  // A datagram may hold line feeds.
  bool continuation(std::string_view line) {
    if (record_.lines.empty()) {
      damage("this is no text log");
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

  // Names hold no blanks but may hold underscores and colons: cut at the last underscore.
  bool read_sender(std::string_view sender, RclLine& entry) {
    if (sender == kCoach) {
      entry.source = RclSource::kTrainer;
      return true;
    }
    const std::size_t cut = sender.rfind('_');
    if (cut == std::string_view::npos || cut == 0) return false;
    const std::string_view who = sender.substr(cut + 1);
    const std::optional<int> unum = base::int_from_text(who);
    const bool player = unum && *unum >= 1 && *unum <= soccer::kPlayersPerTeam;
    if (!player && who != kCoach) return false;
    const std::optional<std::uint8_t> team = team_index(sender.substr(0, cut));
    if (!team) return false;
    entry.team = *team;
    entry.source = player ? RclSource::kPlayer : RclSource::kCoach;
    entry.unum = static_cast<std::uint8_t>(player ? *unum : 0);
    return true;
  }

  std::optional<std::uint8_t> team_index(std::string_view name) {
    auto found = std::find(record_.teams.begin(), record_.teams.end(), name);
    if (found == record_.teams.end()) {
      if (record_.teams.size() == kMaxTeams) return std::nullopt;
      found = record_.teams.emplace(found, name);
    }
    return static_cast<std::uint8_t>(found - record_.teams.begin());
  }

  Damage damage_here(std::string what) const {
    const int cycle = record_.lines.empty() ? 0 : record_.lines.back().time;
    return {input_.line_number(), input_.offset(), cycle, std::move(what)};
  }

  void damage(std::string what) { record_.damage.add(damage_here(std::move(what))); }

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
  auto source = base::open_source(path);
  if (!source) return source.error();
  return read_rcl(**source);
}

}  // namespace cls::gamelog
