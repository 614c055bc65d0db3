// Formats results like rcssserver.
#include "match/server/server_report.h"

#include <fmt/format.h>

#include <array>

#include "soccer/per_side.h"

namespace cls::match {
namespace {

constexpr soccer::PerSide<const char*> kSides = {"Left", "Right"};
constexpr soccer::PerSide<const char*> kCsvSides = {"LEFT", "RIGHT"};

std::string date_of(std::time_t time) {
  std::tm local{};
  localtime_r(&time, &local);
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &local);
  return {text.data(), size};
}

std::string quoted(const std::string& name, char quote, const char* otherwise) {
  return name.empty() ? otherwise : quote + name + quote;
}

bool had_penalties(const ServerReport& report) {
  return report.left.penalties_taken > 0 || report.right.penalties_taken > 0;
}

std::string number_or_null(bool known, int number) {
  return known ? std::to_string(number) : "NULL";
}

}  // namespace

std::string console_report(const ServerReport& report, bool csv_saved) {
  std::string text = fmt::format(
      "\nSaving Results:\n\tCSVSaver: saving...\n\tCSVSaver: ...{}\n\tSTDOutSaver: saving...\n\n"
      "Game Results:\n\t{}\n\t{} vs {}\n",
      csv_saved ? "saved" : "disabled", date_of(report.start),
      quoted(report.left.name, '\'', "null"), quoted(report.right.name, '\'', "null"));

  if (!report.left.coach.empty()) text += fmt::format("\tLeft Coach: '{}'\n", report.left.coach);
  if (!report.right.coach.empty()) text += fmt::format("\tRight Coach: '{}'\n", report.right.coach);
  text += fmt::format("\tScore: {} - {}\n ", report.left.score, report.right.score);
  if (had_penalties(report)) {
    text += fmt::format("\tPenalties: {} ({}) - {} ({})\n", report.left.penalties_scored,
                        report.left.penalties_taken, report.right.penalties_scored,
                        report.right.penalties_taken);
  }
  if (report.coin_toss_winner != soccer::Side::kNeutral) {
    text += fmt::format("\tCoin Toss Winner: {} Team\n", kSides[report.coin_toss_winner]);
  }
  return text + "\n\tSTDOutSaver: ...saved\n\nSaving Results Complete\n";
}

std::string csv_header() {
  return "time, left team, right team, left coach, right coach, left score, right score, left pen "
         "taken, right pen taken, left pen score, right pen score, cointoss\n";
}

std::string csv_line(const ServerReport& report) {
  const bool penalties = had_penalties(report);
  const auto text = [](const std::string& name) { return quoted(name, '"', "NULL"); };
  const auto number = [penalties](int value) { return number_or_null(penalties, value); };
  const bool tossed = report.coin_toss_winner != soccer::Side::kNeutral;
  const char* winner = tossed ? kCsvSides[report.coin_toss_winner] : "NULL";
  return fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}\n", date_of(report.start),
                     text(report.left.name), text(report.right.name), text(report.left.coach),
                     text(report.right.coach), report.left.score, report.right.score,
                     number(report.left.penalties_taken), number(report.right.penalties_taken),
                     number(report.left.penalties_scored), number(report.right.penalties_scored),
                     winner);
}

}  // namespace cls::match
