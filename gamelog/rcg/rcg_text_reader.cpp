// Reads text logs: selects the parser of each line, and parses all lines except shows.
#include "gamelog/rcg/format_readers.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text/number_text.h"
#include "base/text/split.h"
#include "gamelog/rcg/show_scanner.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/scanner.h"

namespace cls::gamelog {
namespace {

using soccer::Scanner;

constexpr std::string_view kNoTeam = "null";

constexpr std::string_view kTeam = "(team ";
constexpr std::size_t kScores = 2;
constexpr std::size_t kScoresAndPenalties = 6;

// The words of `text` between spaces, as views into it.
std::vector<std::string_view> split_at_spaces(std::string_view text) {
  std::vector<std::string_view> words = base::split(text, ' ');
  std::erase(words, "");
  return words;
}

std::string_view joined(std::string_view first, std::string_view last) {
  return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

// True if a result message, `(result DATE LEFT_1-vs-RIGHT_2)`, names these two teams.
bool names_teams(std::string_view result, std::string_view left, std::string_view right) {
  const std::size_t start = result.find(std::string(" ") + std::string(left) + "_");
  return start != std::string_view::npos &&
         result.find("-vs-" + std::string(right) + "_", start) != std::string_view::npos;
}

void set_numbers(const std::vector<int>& numbers, TeamFrames& teams) {
  for (std::size_t i = 0; i < teams.size(); ++i) {
    teams[i].score = numbers[i];

    if (numbers.size() < kScoresAndPenalties) continue;
    teams[i].penalty_scored = numbers[2 + 2 * i];
    teams[i].penalty_missed = numbers[3 + 2 * i];
  }
}

std::optional<int> parse_limited(std::string_view word) {
  const std::optional<int> value = base::parse_int(word);
  return value && fits_text_log(*value) ? value : std::nullopt;
}

// A `(team ...)` record whose names contain spaces, which rcssserver does not allow but other
// writers produce.
struct SpacedNames {
  int time = 0;
  TeamFrames teams;
  std::string names;  ///< both, as in the record
};

// Parses the numbers from the end of the line; split_names() sets the team names. False if the line
// is not such a record.
bool parse_spaced_names(std::string_view line, SpacedNames& record) {
  if (!line.starts_with(kTeam) || !line.ends_with(')')) return false;
  line = line.substr(kTeam.size(), line.size() - kTeam.size() - 1);

  if (line.find_first_of("()") != std::string_view::npos) return false;
  const std::vector<std::string_view> words = split_at_spaces(line);

  std::vector<int> numbers;
  while (numbers.size() < kScoresAndPenalties && words.size() > numbers.size() + 3) {
    const auto number = parse_limited(words[words.size() - 1 - numbers.size()]);
    if (!number) break;
    numbers.push_back(*number);
  }

  if (numbers.size() < kScores) return false;
  if (numbers.size() < kScoresAndPenalties) numbers.resize(kScores);
  std::ranges::reverse(numbers);

  const auto time = parse_limited(words.front());
  if (!time || *time < 0) return false;

  const std::string_view names = joined(words[1], words[words.size() - 1 - numbers.size()]);
  if (names.size() > 2 * kMaxNameLength) return false;

  record = {*time, {}, std::string(names)};
  set_numbers(numbers, record.teams);
  return true;
}

// Splits the names where the result message does. Without a fitting result, splits at the middle
// space. Both together have a limit, so one may be too long: it is cut as all readers limit names.
void split_names(std::string_view names, std::string_view result, TeamFrames& teams) {
  const std::vector<std::string_view> words = split_at_spaces(names);

  std::size_t left_words = (words.size() + 1) / 2;
  if (words.front() == kNoTeam) left_words = 1;
  if (words.back() == kNoTeam) left_words = words.size() - 1;

  for (std::size_t i = 1; i < words.size(); ++i) {
    if (names_teams(result, joined(words.front(), words[i - 1]), joined(words[i], words.back()))) {
      left_words = i;
    }
  }

  const std::array<std::string_view, 2> parts = {joined(words.front(), words[left_words - 1]),
                                                 joined(words[left_words], words.back())};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    teams[i].name = parts[i] == kNoTeam ? std::string_view() : parts[i].substr(0, kMaxNameLength);
  }
}

bool read_team_state(Scanner& in, TeamFrames& teams) {
  for (TeamFrame& team : teams) {
    const std::size_t start = in.position();
    if (!in.literal(" ")) return false;

    // A name contains neither spaces nor brackets, but other servers allow quotes.
    const std::string_view name = in.rest().substr(0, in.rest().find_first_of(" ()"));
    if (name.empty() || name.size() > kMaxNameLength) return in.fail_at(start, "a team name");
    in.literal(name);
    team.name = name == kNoTeam ? std::string_view() : name;
  }

  for (TeamFrame& team : teams) {
    if (!in.sequence(" ", team.score)) return false;
  }

  if (in.peek() == ')') return true;
  for (TeamFrame& team : teams) {
    if (!in.sequence(" ", team.penalty_scored, " ", team.penalty_missed)) return false;
  }

  return true;
}

class TextReader {
 public:
  TextReader(base::InputBuffer& input, RecordBuilder& builder) : input_(input), builder_(builder) {}

  void read_all() {
    for_each_line(input_, builder_, [this](std::string_view line, base::InputBuffer::Line kind) {
      read(line, kind == base::InputBuffer::Line::kUnfinished);
    });
  }

 private:
  void read(std::string_view line, bool unfinished) {
    if (line.starts_with("(show ")) {
      LineError error;
      if (!read_show(line, builder_, error)) {
        add_error(error.column, unfinished ? kTruncated : error.message);
        return;
      }

      if (!error.message.empty()) add_error(error.column, error.message);
      if (builder_.record().frames() == 1) reserve(line.size());
      return;
    }

    Scanner in(line);
    if (!read_other(in, line)) {
      const base::Error error = in.error("record");
      add_error(0, unfinished ? std::string_view(kTruncated) : std::string_view(error.message));
    }
  }

  bool read_other(Scanner& in, std::string_view line) {
    if (in.optional("(playmode ")) return read_play_mode(in, line);
    if (in.optional("(team ")) return read_team(in, line);
    if (in.optional("(msg ")) return read_message(in);
    if (line.starts_with("(server_param ")) return read_parameters(line, builder_.record().server);
    if (line.starts_with("(player_param ")) return read_parameters(line, builder_.record().player);
    if (line.starts_with("(player_type ")) return read_player_type(line);

    if (!line.starts_with('(') || !line.ends_with(')')) return in.fail("a record in parentheses");
    builder_.add_unknown_line(std::string(line));
    return true;
  }

  bool read_play_mode(Scanner& in, std::string_view line) {
    int time = 0;
    std::string_view name;
    if (!(in.sequence(time, " ") && in.token(name) && in.literal(")") && in.end())) {
      return false;
    }

    // An unknown mode of a later server: the previous mode stays in force.
    if (const auto mode = soccer::parse_play_mode(name)) {
      builder_.add_play_mode(time, *mode);
    } else {
      builder_.add_unknown_line(std::string(line));
    }

    return true;
  }

  bool read_team(Scanner& in, std::string_view line) {
    int time = 0;
    TeamFrames teams;

    if (in.integer(time) && read_team_state(in, teams) && in.literal(")") && in.end()) {
      builder_.add_teams(time, teams);
      return true;
    }

    if (!parse_spaced_names(line, spaced_names_)) return false;
    split_names(spaced_names_.names, result_, spaced_names_.teams);
    builder_.add_teams(spaced_names_.time, spaced_names_.teams);
    return true;
  }

  // Only the result message shows where a name with spaces ends.
  void set_result(std::string_view result) {
    result_ = result;
    if (spaced_names_.names.empty()) return;

    const TeamFrames before = spaced_names_.teams;
    split_names(spaced_names_.names, result_, spaced_names_.teams);
    builder_.rename_teams(before, spaced_names_.teams);
  }

  bool read_message(Scanner& in) {
    int time = 0;
    int board = 0;
    std::string_view text;
    if (!(in.sequence(time, " ", board, " \"") && in.rest_before("\")", text))) return false;

    if (text.starts_with("(result ")) set_result(text);
    builder_.add_message(time, board, std::string(text));
    return true;
  }

  // Values that cannot be parsed keep their defaults, so that the rest of the log is read.
  template <typename Params>
  bool read_parameters(std::string_view line, Params& params) {
    const base::Result<void> read = soccer::parse(line, params);
    if (!read) {
      add_error(0, read.error().message);
    } else {
      builder_.add_parameter_line(std::string(line));
    }

    return true;
  }

  bool read_player_type(std::string_view line) {
    soccer::PlayerType type;
    type.id = -1;

    read_parameters(line, type);
    if (!builder_.set_player_type(type)) add_error(0, "player type without an id from 0 to 255");
    return true;
  }

  // Estimates the number of frames by the first show, which is shorter than later ones. The limit
  // applies to very short shows.
  void reserve(std::size_t show_size) {
    constexpr std::uint64_t kLongMatch = 20'000;
    const std::uint64_t rest = input_.source().size_hint();
    reserve_frames(builder_.record(), std::min<std::uint64_t>(rest / show_size + 1, kLongMatch));
  }

  void add_error(std::size_t column, std::string_view message) {
    builder_.add_error(input_, std::string(message), column);
  }

  base::InputBuffer& input_;
  RecordBuilder& builder_;
  SpacedNames spaced_names_;  // of the last such record
  std::string result_;        // the last result message
};

}  // namespace

void read_rcg_text(base::InputBuffer& input, RecordBuilder& builder) {
  TextReader(input, builder).read_all();
}

}  // namespace cls::gamelog
