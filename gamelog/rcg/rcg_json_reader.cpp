// The objects of a JSON log that are not shows, and which reader gets which line.
#include "gamelog/rcg/rcg_json_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/text/json_cursor.h"
#include "gamelog/rcg/rcg_json_show.h"
#include "gamelog/record/record_damage.h"
#include "soccer/messages/parameter_message.h"

namespace cls::gamelog {
namespace {

using soccer::Side;

constexpr int kNoType = -1;

class JsonReader {
 public:
  JsonReader(base::InputBuffer& input, RecordBuilder& builder) : input_(input), builder_(builder) {}

  void read_all() {
    read_lines(input_, builder_, [this](std::string_view line, base::InputBuffer::Line kind) {
      if (!read_line(line)) damage_in(kind);
    });
    if (!closed_ && input_.source().problem().empty() && builder_.record().damage.empty()) {
      damage(0, "the closing bracket is missing: the log was interrupted");
    }
  }

 private:
  // One element of the array, with a comma before or behind it; or a bracket of the array.
  bool read_line(std::string_view line) {
    column_ = 0;
    const std::size_t first = line.find_first_not_of(" \t\r,[");
    if (first == std::string_view::npos) return true;
    if (line[first] == ']') {
      closed_ = true;
      return true;
    }
    element_ = line.substr(first, line.find_last_of('}') + 1 - first);
    base::JsonCursor in(line.substr(first));
    const bool read = read_element(in);
    column_ = first + in.position();
    if (!read) return false;
    if (in.peek() == ',') in.open(',');
    if (in.peek() == ']') closed_ = in.open(']');
    return in.at_end();
  }

  bool read_element(base::JsonCursor& in) {
    std::string_view key;
    if (!in.open('{') || !in.next_key(key)) return false;
    if (key == "type") {  // servers 17 and 18
      std::string kind;
      return in.string(kind) && read_tagged(kind, in);
    }
    const std::string kind(key);
    if (kind == "version" || kind == "timestamp") {
      return in.string(header_field(kind)) && !in.next_key(key) && in.good();
    }
    return in.open('{') && read_body(kind, in) && !in.next_key(key) && in.good();
  }

  bool read_tagged(const std::string& kind, base::JsonCursor& in) {
    if (kind != "header") return read_body(kind, in);
    std::string_view key;
    while (in.next_key(key)) {
      const bool known = key == "version" || key == "timestamp";
      if (!(known ? in.string(header_field(key)) : in.skip_value())) return false;
    }
    return in.good();
  }

  std::string& header_field(std::string_view key) {
    return key == "version" ? builder_.record().server_version : builder_.record().timestamp;
  }

  // Behind the opening bracket, up to and with the closing one.
  bool read_body(const std::string& kind, base::JsonCursor& in) {
    if (kind == "show") return read_show(in);
    if (kind == "playmode") return read_play_mode(in);
    if (kind == "team") return read_team(in);
    if (kind == "msg") return read_message(in);
    if (kind == "team_graphic") return read_team_graphic(in);
    if (kind == "server_param") return read_parameters(kind, in, builder_.record().server);
    if (kind == "player_param") return read_parameters(kind, in, builder_.record().player);
    if (kind == "player_type") return read_player_type(in);
    std::string_view key;
    while (in.next_key(key)) {
      if (!in.skip_value()) return false;
    }
    return in.good() && keep_unknown();
  }

  bool keep_unknown() {
    builder_.unknown_line(std::string(element_));
    return true;
  }

  bool read_show(base::JsonCursor& in) {
    if (!read_json_show(in, frame_)) return false;
    builder_.fill(builder_.begin_frame(frame_.time, frame_.stopped), frame_);
    return true;
  }

  // The keys that all notes have. False if `key` is none of them or its value is wrong.
  static bool read_time(std::string_view key, base::JsonCursor& in, int& time, int& stopped) {
    return (key == "time" && in.integer(time)) || (key == "stime" && in.integer(stopped));
  }

  bool read_play_mode(base::JsonCursor& in) {
    int time = 0;
    int stopped = 0;
    std::string name;
    std::string_view key;
    while (in.next_key(key)) {
      const bool read = key == "mode"
                            ? in.string(name)
                            : read_time(key, in, time, stopped) || (in.good() && in.skip_value());
      if (!read) return false;
    }
    const auto mode = soccer::play_mode_from_name(name);
    if (!mode) return in.good() && keep_unknown();
    builder_.play_mode(time, *mode);
    tell_stopped(stopped);
    return in.good();
  }

  bool read_team(base::JsonCursor& in) {
    int time = 0;
    int stopped = 0;
    TeamFrames teams;
    std::string_view key;
    while (in.next_key(key)) {
      bool read = false;
      if (key == "l" || key == "r") {
        read = in.open('{') && read_one_team(in, teams[key == "l" ? 0 : 1]) != kNoTeam;
      } else if (key == "teams") {
        read = read_team_array(in, teams);
      } else {
        read = read_time(key, in, time, stopped) || (in.good() && in.skip_value());
      }
      if (!read) return false;
    }
    builder_.teams(time, teams);
    tell_stopped(stopped);
    return in.good();
  }

  static constexpr int kNoTeam = -2;

  // Returns the side as a number (soccer::Side) if the object names one, 0 if not, kNoTeam for
  // damage.
  static int read_one_team(base::JsonCursor& in, TeamFrame& team) {
    Side side = Side::kNeutral;
    std::string_view key;
    while (in.next_key(key)) {
      const bool read = key == "name"        ? in.string_or_null(team.name)
                        : key == "score"     ? in.integer(team.score)
                        : key == "pen_score" ? in.integer(team.penalty_scored)
                        : key == "pen_miss"  ? in.integer(team.penalty_missed)
                        : key == "side"      ? read_side(in, side)
                                             : in.skip_value();
      if (!read) return kNoTeam;
    }
    if (!in.good() || team.name.size() > kLongestName) return kNoTeam;
    return soccer::sign(side);
  }

  static bool read_team_array(base::JsonCursor& in, TeamFrames& teams) {
    if (!in.open('[')) return false;
    while (in.next_element()) {
      TeamFrame team;
      if (!in.open('{')) return false;
      const int side = read_one_team(in, team);
      if (side == kNoTeam || side == 0) return false;
      teams[side > 0 ? 0 : 1] = team;
    }
    return in.good();
  }

  bool read_message(base::JsonCursor& in) {
    int time = 0;
    int stopped = 0;
    int board = 1;
    std::string text;
    std::string_view key;
    while (in.next_key(key)) {
      const bool read = key == "board" ? in.integer(board)
                        : key == "message"
                            ? in.string(text)
                            : read_time(key, in, time, stopped) || (in.good() && in.skip_value());
      if (!read) return false;
    }
    builder_.message(time, board, std::move(text));
    tell_stopped(stopped);
    return in.good();
  }

  // As the message that text logs have, which ends with one bracket although two are open.
  bool read_team_graphic(base::JsonCursor& in) {
    std::string side = "l";
    int x = 0;
    int y = 0;
    std::string picture;
    std::string_view key;
    while (in.next_key(key)) {
      bool read = false;
      if (key == "xpm") {
        read = in.open('[');
        while (read && in.next_element()) {
          picture += ' ';
          read = in.scalar_text(picture);
        }
      } else {
        read = key == "side" ? in.string(side)
               : key == "x"  ? in.integer(x)
               : key == "y"  ? in.integer(y)
                             : in.skip_value();
      }
      if (!read || !in.good()) return false;
    }
    builder_.message(0, 1,
                     "(team_graphic_" + side + " (" + std::to_string(x) + " " + std::to_string(y) +
                         picture + ")");
    return in.good();
  }

  // `(name value)` as in text logs. What would end there where it does not is refused.
  static bool append_parameter(std::string_view raw_name, base::JsonCursor& in, std::string& line) {
    const std::string name = base::JsonCursor::unescaped(raw_name);
    std::string value;
    if (!in.scalar_text(value)) return false;
    if (name.empty() || name.find_first_of(" ()\"\n") != std::string::npos ||
        value.find_first_of('\n') != std::string::npos || value.find("\")") != std::string::npos) {
      return false;
    }
    line += '(' + name + ' ' + value + ')';
    return true;
  }

  // Into the text form, which the rest of the program knows how to read.
  static bool append_parameters(base::JsonCursor& in, bool nested, std::string& line) {
    std::string_view key;
    while (in.next_key(key)) {
      const bool inner = key == "params" && !nested;  // servers 17 and 18
      const bool read = inner ? in.open('{') && append_parameters(in, true, line)
                              : append_parameter(key, in, line);
      if (!read) return false;
    }
    return in.good();
  }

  template <typename Params>
  bool read_parameters(const std::string& kind, base::JsonCursor& in, Params& params) {
    std::string line = "(" + kind + " ";
    if (!append_parameters(in, false, line)) return false;
    line += ')';
    const base::Result<void> read = soccer::parse(line, params);
    if (!read) {
      damage(0, read.error().message);
    } else {
      builder_.parameter_line(std::move(line));
    }
    return true;
  }

  bool read_player_type(base::JsonCursor& in) {
    soccer::PlayerType type;
    type.id = kNoType;
    if (!read_parameters("player_type", in, type)) return false;
    return builder_.player_type(type);
  }

  // Where the log is silent, the builder finds out.
  void tell_stopped(int stopped) {
    if (stopped > 0) builder_.note_stopped(stopped);
  }

  void damage_in(base::InputBuffer::Line kind) {
    damage(column_, kind == base::InputBuffer::Line::kUnfinished ? kCutOff
                                                                 : "this is no JSON of a game log");
  }

  void damage(std::size_t column, std::string what) {
    MatchRecord& record = builder_.record();
    record.damage.add(damage_at(input_, record, std::move(what), column));
  }

  base::InputBuffer& input_;
  RecordBuilder& builder_;
  Frame frame_;
  std::string_view element_;  // without comma and blanks around it
  std::size_t column_ = 0;
  bool closed_ = false;
};

}  // namespace

void read_rcg_json(base::InputBuffer& input, RecordBuilder& builder) {
  JsonReader(input, builder).read_all();
}

}  // namespace cls::gamelog
