// Labels and meanings; a test compares the labels with what the commands print.
#include "cli/explain/table_rows.h"

#include <cctype>
#include <string>

namespace cls::cli {
namespace {

constexpr const char* kMatch = "cls match";
constexpr const char* kStats = "cls stats";
constexpr const char* kPlayers = "cls stats, players";

constexpr TableRow kRows[] = {
    {kMatch, "playmaker", "the side as it was given"},
    {kMatch, "decisions", "decisions that agents of cls had to make: one for each agent and cycle"},
    {kMatch, "missed (late)",
     "decisions without a usable reply of the Playmaker; of these, replies that came too late"},
    {kMatch, "reconnects", "times that the connection to the Playmaker was made again"},
    {kMatch, "rpc p50 / p95",
     "time from call to reply of the median player: half of the calls took less, 95 % took less"},
    {kMatch, "rpc worst p99 / max",
     "the same of the slowest player: 99 % of its calls took less; its longest call"},
    {kMatch, "actions executed", "requested actions that became a command"},
    {kMatch, "failed, skipped",
     "actions that were not possible; actions behind the first possible one of their kind"},
    {kMatch, "invalid or unknown", "actions with wrong values, or that this proxy does not know"},
    {kMatch, "kick", "kick commands sent"},
    {kMatch, "dash", "dash commands sent"},
    {kMatch, "turn", "turn commands sent"},
    {kMatch, "tackle", "tackle commands sent"},
    {kMatch, "catch", "catch commands sent"},
    {kMatch, "undecided cycles", "cycles that began while the player still decided the one before"},
    {kMatch, "late commands", "commands that reached the server after its cycle"},
    {kMatch, "late wake-ups", "decisions that began more than 10 ms late: the host was busy"},
    {kMatch, "cpu seconds", "processor time of the programs that cls started for the side"},
    {kStats, "possession (last touch)", "share of live play after a touch of the team"},
    {kStats, "ball at feet", "share of the frames with a player who can kick"},
    {kStats, "fastest to the ball",
     "share of live play in which a player of the team is nearest in time"},
    {kStats, "touches", "kicks, tackles that hit the ball, and catches"},
    {kStats, "passes completed", "passes that a teammate touched next, of those attempted"},
    {kStats, "mean pass", "mean length of completed passes, meters"},
    {kStats, "through passes, crosses, one-twos",
     "passes behind the defense; from the wing in front of the goal; there and back between two"},
    {kStats, "dribbles, take-ons", "runs with the ball; opponents passed by them"},
    {kStats, "shots on target", "shots between the posts, of all"},
    {kStats, "goal, saved, blocked, wide, post", "the shots by their end"},
    {kStats, "expected goals", "goals that such shots bring on average"},
    {kStats, "box entries, touches in the box",
     "times that the ball came into the opponents' penalty area; touches there"},
    {kStats, "pitch control", "share of the pitch that the team reaches first"},
    {kStats, "successful tackles", "tackles that hit the ball, of all"},
    {kStats, "interceptions, recoveries",
     "passes of the opponents ended; times that the ball was won in any way"},
    {kStats, "opponent passes per defensive action",
     "in the opponents' 60 % of the pitch; few mean high pressing"},
    {kStats, "saves, catches", "shots on target that the goalie ended; balls it caught"},
    {kStats, "offsides, fouls", "of the team"},
    {kStats, "yellow, red cards", "for players of the team"},
    {kStats, "kick-ins, corners, goal kicks", "given to the team"},
    {kStats, "free kicks, indirect", "given to the team"},
    {kStats, "distance", "way of all players, kilometers"},
    {kStats, "formation", "lines from the back to the front, without the goalie"},
    {kStats, "length x width", "mean extent of the field players, meters"},
    {kStats, "silent steps", "steps in which a player sent nothing, of all; needs the text log"},
    {kStats, "rejected commands", "that the server did not execute; needs the text log"},
    {kPlayers, "touches", "as of the team"},
    {kPlayers, "passes", "completed, of those attempted"},
    {kPlayers, "dribbles", "runs with the ball"},
    {kPlayers, "shots", "on target, of all"},
    {kPlayers, "goals", "without own goals"},
    {kPlayers, "tackles", "that hit the ball, of all"},
    {kPlayers, "recoveries", "balls won in any way"},
    {kPlayers, "losses", "balls lost to the opponents"},
    {kPlayers, "fouls", "committed"},
    {kPlayers, "meters", "distance covered"},
    {kPlayers, "stamina", "stamina used"},
    {kPlayers, "silent", "steps without a message; needs the text log"},
    {kPlayers, "rating", "orders the players of a match by what they did, and has no other use"},
};

// Lower case, with a space for each run of other characters than letters and digits.
std::string words_of(std::string_view text) {
  std::string words = " ";
  for (const char c : text) {
    const bool in_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (in_word) {
      words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (words.back() != ' ') {
      words += ' ';
    }
  }
  if (words.back() != ' ') words += ' ';
  return words;
}

}  // namespace

std::span<const TableRow> table_rows() { return kRows; }

std::vector<const TableRow*> rows_with_label(std::string_view word) {
  const std::string wanted = words_of(word);
  std::vector<const TableRow*> found;
  for (const TableRow& row : kRows) {
    if (words_of(row.label) == wanted) found.push_back(&row);
  }
  return found;
}

std::vector<const TableRow*> find_rows(std::string_view word) {
  std::vector<const TableRow*> found = rows_with_label(word);
  const std::string wanted = words_of(word);
  if (!found.empty() || wanted == " ") return found;
  for (const TableRow& row : kRows) {
    if (words_of(row.label).find(wanted) != std::string::npos) found.push_back(&row);
  }
  return found;
}

}  // namespace cls::cli
