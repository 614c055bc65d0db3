// Writes the lines of a game log in order, as text or JSON.
#include "gamelog/rcg/record_writer.h"

#include <cassert>
#include <string>

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
  struct Writer {
    const Note& note;
    std::string& out;
    void operator()(soccer::PlayMode mode) const { append_play_mode(note.time, mode, out); }
    void operator()(const TeamFrames& teams) const {
      append_team(note.time, with_text_names(teams), out);
    }
    void operator()(const Message& m) const { append_message(note.time, m.board, m.text, out); }
    void operator()(const UnknownLine& line) const {
      if (!line.text.starts_with('(')) return;
      out += line.text;
      out += '\n';
    }
  };

  std::visit(Writer{note, out}, note.content);
}

void append_json_note(const Note& note, std::string& out) {
  struct Writer {
    const Note& note;
    std::string& out;
    void operator()(soccer::PlayMode mode) const {
      append_json_play_mode(note.time, note.stopped, mode, out);
    }
    void operator()(const TeamFrames& teams) const {
      append_json_team(note.time, note.stopped, teams, out);
    }
    void operator()(const Message& message) const {
      append_json_message(note.time, note.stopped, message, out);
    }
    void operator()(const UnknownLine& line) const {
      if (line.text.starts_with('{')) out += line.text;
    }
  };

  std::visit(Writer{note, out}, note.content);
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

  std::string& begin() {
    line_ = first_ ? "" : ",\n";
    return line_;
  }

  // Empty elements are left out.
  void end() {
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

  if (!record.server_version.empty()) {
    append_json_text("version", record.server_version, array.begin());
    array.end();
  }
  if (!record.timestamp.empty()) {
    append_json_text("timestamp", record.timestamp, array.begin());
    array.end();
  }

  for (const std::string& parameters : parameter_lines(record)) {
    append_json_parameters(parameters, array.begin());
    array.end();
  }

  for_each_line(
      record,
      [&](const Note& note) {
        append_json_note(note, array.begin());
        array.end();
      },
      [&](const Frame& frame) {
        append_json_show(frame, array.begin());
        array.end();
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
