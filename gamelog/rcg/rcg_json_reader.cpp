// Reads JSON logs: selects the parser of each line, and parses all objects except shows.
#include "gamelog/rcg/format_readers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/text/json_cursor.h"
#include "gamelog/rcg/rcg_json_show.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/scanner.h"

namespace cls::gamelog {
namespace {

using soccer::Side;

constexpr int kNoType = -1;

bool read_integer(base::JsonCursor& in, int& value) {
  return in.integer(value) && fits_text_log(value);
}

class JsonReader {
 public:
  JsonReader(base::InputBuffer& input, RecordBuilder& builder) : input_(input), builder_(builder) {}

  void read_all() {
    for_each_line(input_, builder_, [this](std::string_view line, base::InputBuffer::Line kind) {
      if (read_line(line)) return;
      const bool truncated = kind == base::InputBuffer::Line::kUnfinished;
      add_error(column_, truncated ? kTruncated : "not an element of a JSON game log");
    });

    if (!closed_ && input_.source().error().empty() && builder_.record().errors.empty()) {
      add_error(0, "closing bracket missing: the log is incomplete");
    }
  }

 private:
  // Parses one element of the array, with a comma before or after it, or a bracket of the array.
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

    const auto read = [&](std::string_view key) {
      const bool known = key == "version" || key == "timestamp";
      return known ? in.string(header_field(key)) : in.skip_value();
    };
    return read_members(in, read) && in.good();
  }

  std::string& header_field(std::string_view key) {
    return key == "version" ? builder_.record().server_version : builder_.record().timestamp;
  }

  // Parses the members and the closing bracket.
  bool read_body(const std::string& kind, base::JsonCursor& in) {
    if (kind == "show") return read_show(in);
    if (kind == "playmode") return read_play_mode(in);
    if (kind == "team") return read_team(in);
    if (kind == "msg") return read_message(in);
    if (kind == "team_graphic") return read_team_graphic(in);
    if (kind == "server_param") return read_parameters(kind, in, builder_.record().server);
    if (kind == "player_param") return read_parameters(kind, in, builder_.record().player);
    if (kind == "player_type") return read_player_type(in);

    return read_members(in, [&in](std::string_view) { return in.skip_value(); }) && in.good() &&
           add_unknown();
  }

  // Calls `read(key)` for each member up to the closing bracket or a syntax error. False if one
  // call is.
  template <typename Read>
  static bool read_members(base::JsonCursor& in, Read read) {
    std::string_view key;
    while (in.next_key(key)) {
      if (!read(key)) return false;
    }
    return true;
  }

  bool add_unknown() {
    builder_.add_unknown_line(std::string(element_));
    return true;
  }

  bool read_show(base::JsonCursor& in) {
    if (!read_json_show(in, frame_)) return false;
    builder_.fill_frame(builder_.begin_frame(frame_.time, frame_.stopped), frame_);
    return true;
  }

  // Parses a member that all notes can have, or skips one of another name.
  static bool read_time_or_skip(std::string_view key, base::JsonCursor& in, int& time,
                                int& stopped) {
    return key == "time"    ? read_integer(in, time)
           : key == "stime" ? read_integer(in, stopped)
                            : in.skip_value();
  }

  bool read_play_mode(base::JsonCursor& in) {
    int time = 0;
    int stopped = 0;
    std::string name;
    const auto read = [&](std::string_view key) {
      return key == "mode" ? in.string(name) : read_time_or_skip(key, in, time, stopped);
    };
    if (!read_members(in, read)) return false;

    const auto mode = soccer::parse_play_mode(name);
    if (!mode) return in.good() && add_unknown();

    builder_.add_play_mode(time, *mode);
    set_stopped(stopped);
    return in.good();
  }

  bool read_team(base::JsonCursor& in) {
    int time = 0;
    int stopped = 0;
    TeamFrames teams;
    const auto read = [&](std::string_view key) {
      if (key == "l" || key == "r") {
        return in.open('{') && read_one_team(in, teams[key == "l" ? 0 : 1]) != kNoTeam;
      }
      return key == "teams" ? read_team_array(in, teams)
                            : read_time_or_skip(key, in, time, stopped);
    };
    if (!read_members(in, read)) return false;

    builder_.add_teams(time, teams);
    set_stopped(stopped);
    return in.good();
  }

  static constexpr int kNoTeam = -2;

  // Returns the side as a number (soccer::Side) if the object has one, otherwise 0; kNoTeam for a
  // parse error.
  static int read_one_team(base::JsonCursor& in, TeamFrame& team) {
    Side side = Side::kNeutral;
    const auto read = [&](std::string_view key) {
      return key == "name"        ? in.string_or_null(team.name)
             : key == "score"     ? read_integer(in, team.score)
             : key == "pen_score" ? read_integer(in, team.penalty_scored)
             : key == "pen_miss"  ? read_integer(in, team.penalty_missed)
             : key == "side"      ? read_side(in, side)
                                  : in.skip_value();
    };

    if (!read_members(in, read)) return kNoTeam;
    if (!in.good() || team.name.size() > kMaxNameLength) return kNoTeam;
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
    const auto read = [&](std::string_view key) {
      return key == "board"     ? read_integer(in, board)
             : key == "message" ? in.string(text)
                                : read_time_or_skip(key, in, time, stopped);
    };
    if (!read_members(in, read)) return false;

    builder_.add_message(time, board, std::move(text));
    set_stopped(stopped);
    return in.good();
  }

  // Stores the message of text logs, which opens two brackets and closes one.
  bool read_team_graphic(base::JsonCursor& in) {
    std::string side = "l";
    int x = 0;
    int y = 0;
    std::string picture;
    const auto read_picture = [&] {
      bool read = in.open('[');
      while (read && in.next_element()) {
        picture += ' ';
        read = in.scalar_text(picture);
      }
      return read && in.good();
    };

    const auto read = [&](std::string_view key) {
      return key == "xpm"    ? read_picture()
             : key == "side" ? in.string(side)
             : key == "x"    ? in.integer(x)
             : key == "y"    ? in.integer(y)
                             : in.skip_value();
    };
    if (!read_members(in, read)) return false;

    builder_.add_message(0, 1,
                         "(team_graphic_" + side + " (" + std::to_string(x) + " " +
                             std::to_string(y) + picture + ")");
    return in.good();
  }

  // Appends `(name value)` as in text logs. False if the text log's parser would end the value
  // elsewhere.
  static bool append_parameter(std::string_view raw_name, base::JsonCursor& in, std::string& line) {
    const std::string name = base::JsonCursor::unescape(raw_name);
    std::string value;

    if (!in.scalar_text(value)) return false;
    if (name.empty() || name.find_first_of(" ()\"\n") != std::string::npos ||
        value.find_first_of('\n') != std::string::npos || value.find("\")") != std::string::npos) {
      return false;
    }

    line += '(' + name + ' ' + value + ')';
    return true;
  }

  // Converts parameters to the text form, for which a parser exists.
  static bool append_parameters(base::JsonCursor& in, bool nested, std::string& line) {
    const auto read = [&](std::string_view key) {
      const bool inner = key == "params" && !nested;  // servers 17 and 18
      return inner ? in.open('{') && append_parameters(in, true, line)
                   : append_parameter(key, in, line);
    };
    return read_members(in, read) && in.good();
  }

  template <typename Params>
  bool read_parameters(const std::string& kind, base::JsonCursor& in, Params& params) {
    std::string line = "(" + kind + " ";
    if (!append_parameters(in, false, line)) return false;

    line += ')';
    if (const auto read = soccer::parse(line, params); !read) {
      add_error(0, read.error().message);
    } else {
      builder_.add_parameter_line(std::move(line));
    }
    return true;
  }

  bool read_player_type(base::JsonCursor& in) {
    soccer::PlayerType type;
    type.id = kNoType;
    if (!read_parameters("player_type", in, type)) return false;
    return builder_.set_player_type(type);
  }

  // Without a recorded value, the builder counts stopped cycles.
  void set_stopped(int stopped) {
    if (stopped > 0) builder_.set_stopped(stopped);
  }

  void add_error(std::size_t column, std::string message) {
    builder_.add_error(input_, std::move(message), column);
  }

  base::InputBuffer& input_;
  RecordBuilder& builder_;
  Frame frame_;
  std::string_view element_;  // without the surrounding comma and spaces
  std::size_t column_ = 0;
  bool closed_ = false;
};

}  // namespace

void read_rcg_json(base::InputBuffer& input, RecordBuilder& builder) {
  JsonReader(input, builder).read_all();
}

}  // namespace cls::gamelog
