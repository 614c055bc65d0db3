// The lines of text logs that are not shows, and which reader gets which line.
#include "gamelog/rcg/rcg_text_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "gamelog/rcg/show_scanner.h"
#include "gamelog/record/blank_names.h"
#include "gamelog/record/record_damage.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/scanner.h"

namespace cls::gamelog {
namespace {

using soccer::Scanner;

constexpr std::string_view kNoTeam = "null";

bool read_team_state(Scanner& in, TeamFrames& teams) {
  for (TeamFrame& team : teams) {
    const std::size_t start = in.position();
    std::string_view name;
    if (!in.literal(" ")) return false;
    // A name holds neither blanks nor brackets, but perhaps quotes of a foreign server.
    const std::size_t length = std::min(in.rest().find_first_of(" ()"), in.rest().size());
    name = in.rest().substr(0, length);
    if (name.empty() || length > kLongestName) return in.fail_at(start, "a team name");
    in.literal(name);
    team.name = name == kNoTeam ? std::string_view() : name;
  }
  for (TeamFrame& team : teams) {
    if (!(in.literal(" ") && in.integer(team.score))) return false;
  }
  if (in.peek() == ')') return true;
  for (TeamFrame& team : teams) {
    if (!(in.literal(" ") && in.integer(team.penalty_scored) && in.literal(" ") &&
          in.integer(team.penalty_missed))) {
      return false;
    }
  }
  return true;
}

class TextReader {
 public:
  TextReader(base::InputBuffer& input, RecordBuilder& builder) : input_(input), builder_(builder) {}

  void read_all() {
    read_lines(input_, builder_, [this](std::string_view line, base::InputBuffer::Line kind) {
      read(line, kind == base::InputBuffer::Line::kUnfinished);
    });
  }

 private:
  void read(std::string_view line, bool unfinished) {
    if (line.starts_with("(show ")) {
      LineProblem problem;
      if (!read_show(line, builder_, problem)) {
        damage(problem.column, unfinished ? kCutOff : problem.what);
      } else if (builder_.record().frames() == 1) {
        reserve(line.size());
      }
      return;
    }
    Scanner in(line);
    if (!read_other(in, line)) {
      const base::Error error = in.error("record");
      damage(0, unfinished ? std::string_view(kCutOff) : std::string_view(error.message));
    }
  }

  bool read_other(Scanner& in, std::string_view line) {
    if (in.optional("(playmode ")) return read_play_mode(in, line);
    if (in.optional("(team ")) return read_team(in, line);
    if (in.optional("(msg ")) return read_message(in);
    if (line.starts_with("(server_param ")) return read_parameters(line, builder_.record().server);
    if (line.starts_with("(player_param ")) return read_parameters(line, builder_.record().player);
    if (line.starts_with("(player_type ")) return read_player_type(line);
    if (!line.starts_with('(') || !line.ends_with(')')) return in.fail("a record in brackets");
    builder_.unknown_line(std::string(line));
    return true;
  }

  bool read_play_mode(Scanner& in, std::string_view line) {
    int time = 0;
    std::string_view name;
    if (!(in.integer(time) && in.literal(" ") && in.word(name) && in.literal(")") && in.end())) {
      return false;
    }
    // A mode that later servers know: the one before goes on as far as we can tell.
    const auto mode = soccer::play_mode_from_name(name);
    if (mode) {
      builder_.play_mode(time, *mode);
    } else {
      builder_.unknown_line(std::string(line));
    }
    return true;
  }

  bool read_team(Scanner& in, std::string_view line) {
    int time = 0;
    TeamFrames teams;
    if (in.integer(time) && read_team_state(in, teams) && in.literal(")") && in.end()) {
      builder_.teams(time, teams);
      return true;
    }
    if (!read_blank_names(line, blank_names_)) return false;
    split_names(blank_names_.names, result_, blank_names_.teams);
    builder_.teams(blank_names_.time, blank_names_.teams);
    return true;
  }

  // Only the result of a match tells where a name with blanks ends.
  void take_result(std::string_view result) {
    result_ = result;
    if (blank_names_.names.empty()) return;
    const TeamFrames before = blank_names_.teams;
    split_names(blank_names_.names, result_, blank_names_.teams);
    builder_.rename(before, blank_names_.teams);
  }

  bool read_message(Scanner& in) {
    int time = 0;
    int board = 0;
    std::string_view text;
    if (!(in.integer(time) && in.literal(" ") && in.integer(board) && in.literal(" \"") &&
          in.rest_before("\")", text))) {
      return false;
    }
    if (text.starts_with("(result ")) take_result(text);
    builder_.message(time, board, std::string(text));
    return true;
  }

  // Values that cannot be read keep their defaults: the rest of the log is worth more.
  template <typename Params>
  bool read_parameters(std::string_view line, Params& params) {
    const base::Result<void> read = soccer::parse(line, params);
    if (!read) {
      damage(0, read.error().message);
    } else {
      builder_.parameter_line(std::string(line));
    }
    return true;
  }

  bool read_player_type(std::string_view line) {
    soccer::PlayerType type;
    type.id = -1;
    read_parameters(line, type);
    if (!builder_.player_type(type)) damage(0, "a player type without a number from 0 to 255");
    return true;
  }

  // Shows grow longer with their numbers, so the first one tells a little too much room. A tiny one
  // must not claim room for millions.
  void reserve(std::size_t show_size) {
    constexpr std::uint64_t kLongMatch = 20'000;
    const std::uint64_t rest = input_.source().size_hint();
    reserve_frames(builder_.record(), std::min<std::uint64_t>(rest / show_size + 1, kLongMatch));
  }

  void damage(std::size_t column, std::string_view what) {
    MatchRecord& record = builder_.record();
    record.damage.add(damage_at(input_, record, std::string(what), column));
  }

  base::InputBuffer& input_;
  RecordBuilder& builder_;
  BlankNames blank_names_;  // the last such record
  std::string result_;      // the last result message
};

}  // namespace

void read_rcg_text(base::InputBuffer& input, RecordBuilder& builder) {
  TextReader(input, builder).read_all();
}

}  // namespace cls::gamelog
