// Writes the lines of a game log in order, as text or JSON.
#include "gamelog/rcg/record_writer.h"

#include <cassert>
#include <string>

#include "base/overloaded.h"
#include "gamelog/rcg/rcg_json_text.h"
#include "gamelog/rcg/rcg_text.h"
#include "soccer/messages/parameter_message.h"

namespace cls::gamelog {
namespace {

std::vector<std::string> parameter_lines(const MatchRecord& record) {
  if (!record.parameter_lines.empty()) return record.parameter_lines;

  std::vector<std::string> lines(2);
  soccer::format(record.server, soccer::kAllVersions, lines[0]);
  soccer::format(record.player, soccer::kAllVersions, lines[1]);
  return lines;
}

// Calls `note` and `frame` for each line, in the order of the log.
template <typename OnNote, typename OnFrame>
void for_each_line(const MatchRecord& record, OnNote note, OnFrame frame) {
  std::size_t next = 0;
  for (std::size_t i = 0; i <= record.frames(); ++i) {
    for (; next < record.notes.size() && record.notes[next].frame <= i; ++next) {
      note(record.notes[next]);
    }
    if (i < record.frames()) frame(frame_at(record, i));
  }
}

// Team names in JSON logs of other programs may contain separators of text logs.
TeamFrames with_text_names(TeamFrames teams) {
  for (TeamFrame& team : teams) {
    for (char& c : team.name) {
      if (static_cast<unsigned char>(c) <= ' ' || c == '(' || c == ')') c = '_';
    }
  }

  return teams;
}

void append_note(const Note& note, std::string& out) {
  const base::Overloaded write = {
      [&](soccer::PlayMode mode) { append_play_mode(note.time, mode, out); },
      [&](const TeamFrames& teams) { append_team(note.time, with_text_names(teams), out); },
      [&](const Message& m) { append_message(note.time, m.board, m.text, out); },
      [&](const UnknownLine& line) {
        if (line.text.starts_with('(')) out += line.text + '\n';
      }};
  std::visit(write, note.content);
}

void append_json_note(const Note& note, std::string& out) {
  const base::Overloaded write = {
      [&](soccer::PlayMode mode) { append_json_play_mode(note.time, note.stopped, mode, out); },
      [&](const TeamFrames& teams) { append_json_team(note.time, note.stopped, teams, out); },
      [&](const Message& m) { append_json_message(note.time, note.stopped, m, out); },
      [&](const UnknownLine& line) {
        if (line.text.starts_with('{')) out += line.text;
      }};
  std::visit(write, note.content);
}

void write_text(const MatchRecord& record, RcgVersion version, base::ByteSink& sink) {
  std::string line;
  append_version(version, line);
  for (const std::string& parameters : parameter_lines(record)) line += parameters + "\n";
  sink.write(line);

  for_each_line(
      record,
      [&](const Note& note) {
        line.clear();
        append_note(note, line);
        sink.write(line);
      },
      [&](const Frame& frame) {
        line.clear();
        append_show(frame, line, version);
        sink.write(line);
      });
}

// Writes array elements with commas between them.
class JsonArray {
 public:
  explicit JsonArray(base::ByteSink& sink) : sink_(sink) { sink_.write("[\n"); }

  // An element, which `append(text)` writes; empty ones are left out.
  template <typename Append>
  void add(Append append) {
    line_ = first_ ? "" : ",\n";
    append(line_);
    if (line_.size() <= 2) return;

    sink_.write(line_);
    first_ = false;
  }

  void close() { sink_.write("\n]\n"); }

 private:
  base::ByteSink& sink_;
  std::string line_;
  bool first_ = true;
};

void write_json(const MatchRecord& record, base::ByteSink& sink) {
  JsonArray array(sink);

  const auto add_text = [&array](std::string_view key, const std::string& value) {
    if (!value.empty()) array.add([&](std::string& out) { append_json_text(key, value, out); });
  };

  add_text("version", record.server_version);
  add_text("timestamp", record.timestamp);
  for (const std::string& line : parameter_lines(record)) {
    array.add([&line](std::string& out) { append_json_parameters(line, out); });
  }

  for_each_line(
      record,
      [&](const Note& note) {
        array.add([&note](std::string& out) { append_json_note(note, out); });
      },
      [&](const Frame& frame) {
        array.add([&frame](std::string& out) { append_json_show(frame, out); });
      });

  array.close();
}

}  // namespace

void write_rcg(const MatchRecord& record, RcgVersion version, base::ByteSink& sink) {
  assert(version >= RcgVersion::kV4);
  if (version == RcgVersion::kJson) {
    write_json(record, sink);
  } else {
    write_text(record, version, sink);
  }
}

}  // namespace cls::gamelog
