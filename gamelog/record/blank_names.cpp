// Splitting at blanks that belong to names.
#include "gamelog/record/blank_names.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "base/text/number_text.h"
#include "gamelog/record/record_builder.h"

namespace cls::gamelog {
namespace {

constexpr std::string_view kTeam = "(team ";
constexpr std::string_view kNoTeam = "null";
constexpr std::size_t kScores = 2;
constexpr std::size_t kScoresAndPenalties = 6;

// Views into `text`.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t start = text.find_first_not_of(' '); start != std::string_view::npos;
       start = text.find_first_not_of(' ', start)) {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    words.push_back(text.substr(start, end - start));
    start = end;
  }
  return words;
}

std::string_view joined(std::string_view first, std::string_view last) {
  return {first.data(), static_cast<std::size_t>(last.data() + last.size() - first.data())};
}

// A result names the left team first and the right one behind "-vs-".
bool fits(std::string_view result, std::string_view left, std::string_view right) {
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

}  // namespace

bool read_blank_names(std::string_view line, BlankNames& record) {
  if (!line.starts_with(kTeam) || !line.ends_with(')')) return false;
  line = line.substr(kTeam.size(), line.size() - kTeam.size() - 1);
  if (line.find_first_of("()") != std::string_view::npos) return false;
  const std::vector<std::string_view> words = words_of(line);
  std::vector<int> numbers;
  while (numbers.size() < kScoresAndPenalties && words.size() > numbers.size() + 3) {
    const auto number = base::int_from_text(words[words.size() - 1 - numbers.size()]);
    if (!number) break;
    numbers.push_back(*number);
  }
  if (numbers.size() < kScores) return false;
  if (numbers.size() < kScoresAndPenalties) numbers.resize(kScores);
  std::reverse(numbers.begin(), numbers.end());
  const auto time = base::int_from_text(words.front());
  if (!time || *time < 0) return false;
  const std::string_view names = joined(words[1], words[words.size() - 1 - numbers.size()]);
  if (names.size() > 2 * kLongestName) return false;
  record = {*time, {}, std::string(names)};
  set_numbers(numbers, record.teams);
  return true;
}

void split_names(std::string_view names, std::string_view result, TeamFrames& teams) {
  const std::vector<std::string_view> words = words_of(names);
  std::size_t left_words = (words.size() + 1) / 2;
  if (words.front() == kNoTeam) left_words = 1;
  if (words.back() == kNoTeam) left_words = words.size() - 1;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (fits(result, joined(words.front(), words[i - 1]), joined(words[i], words.back()))) {
      left_words = i;
    }
  }
  const std::array<std::string_view, 2> parts = {joined(words.front(), words[left_words - 1]),
                                                 joined(words[left_words], words.back())};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    teams[i].name = parts[i] == kNoTeam ? std::string_view() : parts[i];
  }
}

}  // namespace cls::gamelog
