// Differences of two matches, and the page that shows both.
#include "viewer/report/compare_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/gamelog/recorded_match.h"
#include "tests/viewer/markup.h"
#include "tests/viewer/record_difference.h"
#include "viewer/page/encoding.h"
#include "viewer/page/page.h"

namespace cls::viewer {
namespace {

using testing::HasSubstr;
using tests::record_of;

/// Statistics refer to the record.
struct Match {
  explicit Match(gamelog::MatchRecord given)
      : record(std::move(given)),
        statistics(analysis::compute_statistics(record, nullptr)),
        summary(analysis::summarize(record, nullptr)) {}

  ComparedMatch compared() const { return {&summary, &statistics}; }

  gamelog::MatchRecord record;
  analysis::MatchStatistics statistics;
  analysis::MatchSummary summary;
};

TEST(MatchDifference, IsNoneForEqualRecords) {
  const gamelog::MatchRecord record = record_of("match-start");
  EXPECT_FALSE(first_difference(record, record));
  EXPECT_EQ(difference_text(first_difference(record, record)), "none");
}

TEST(MatchDifference, IsTheFirstFrameWithAnotherValue) {
  const gamelog::MatchRecord record = record_of("match-start");
  gamelog::MatchRecord changed = record;
  changed.players.stamina[120 * gamelog::kSlots + 6] += 1.0F;
  changed.ball_position[121].x += 0.5F;
  changed.mode[121] = soccer::PlayMode::kTimeOver;
  const auto found = first_difference(record, changed);

  ASSERT_TRUE(found);
  EXPECT_EQ(found->frame, 120U);
  EXPECT_EQ(found->cycle, record.time[120]);
  EXPECT_EQ(found->what, std::vector<std::string>{"left 7 stamina"});

  changed.players.stamina[120 * gamelog::kSlots + 6] -= 1.0F;
  EXPECT_EQ(first_difference(record, changed)->what,
            (std::vector<std::string>{"play mode", "ball position"}));
}

TEST(MatchDifference, NamesAFewOfManyValues) {
  const gamelog::MatchRecord record = record_of("match-start");
  gamelog::MatchRecord changed = record;
  for (std::size_t slot = 0; slot < 6; ++slot) {
    changed.players.body[50 * gamelog::kSlots + slot] += 1.0F;
  }
  EXPECT_EQ(difference_text(first_difference(record, changed)),
            "cycle " + std::to_string(record.time[50]) +
                " (frame 50): left 1 body, left 2 body, left 3 body, left 4 body and 2 more");
}

TEST(MatchDifference, FindsTheEndOfAShorterLog) {
  const gamelog::MatchRecord record = record_of("match-start");
  gamelog::MatchRecord shorter = record;
  gamelog::resize_frames(shorter, 100);
  for (const auto& found : {first_difference(record, shorter), first_difference(shorter, record)}) {
    ASSERT_TRUE(found);
    EXPECT_EQ(found->frame, 100U);
    EXPECT_EQ(found->what, std::vector<std::string>{"end of the log"});
  }
  EXPECT_TRUE(first_difference(record, {}));
  EXPECT_FALSE(first_difference({}, {}));
}

TEST(MatchDifference, ListsEventsOfOneMatchOnly) {
  const Match match(record_of("match-start"));
  ASSERT_FALSE(match.statistics.goals.empty());
  EXPECT_TRUE(lone_events(match.statistics, match.statistics).empty());

  analysis::MatchStatistics without = match.statistics;
  without.goals.clear();
  const auto first = lone_events(match.statistics, without);
  const auto second = lone_events(without, match.statistics);

  ASSERT_EQ(first.size(), match.statistics.goals.size());
  ASSERT_EQ(second.size(), first.size());
  EXPECT_EQ(first[0].match, 0U);
  EXPECT_EQ(second[0].match, 1U);
  EXPECT_EQ(first[0].cycle, match.statistics.goals[0].cycle);
  EXPECT_TRUE(first[0].text.starts_with("goal, left ")) << first[0].text;
}

TEST(MatchDifference, NamesFoulsInWords) {
  const Match match(record_of("match-start"));
  analysis::MatchStatistics with = match.statistics;
  with.stoppages.fouls.push_back({100, soccer::PlayMode::kFoulChargeRight, 15, 4});
  const auto events = lone_events(with, match.statistics);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].text, "foul, right 5: foul charge");
}

TEST(MatchDifference, SubtractsFigures) {
  const Match a(record_of("match-start"));
  Match b(record_of("match-start"));
  for (const auto& row : difference_rows(a.compared(), b.compared())) {
    ASSERT_EQ(row.size(), 7U);
    EXPECT_TRUE(row[0].empty() || row[3] == "0") << row[0] << row[3];
  }
  b.summary.teams[0].score += 2;
  const auto rows = difference_rows(a.compared(), b.compared());
  EXPECT_EQ(rows[1], (std::vector<std::string>{"goals", "1", "3", "+2", "0", "0", "0"}));
}

TEST(ComparePage, HoldsBothMatches) {
  const Match a(record_of("match-start"));
  Match b(record_of("match-start"));
  b.record.ball_position[100].x += 1.0F;
  const std::array<std::vector<PageDrawings>, 2> drawings = {
      {{{soccer::Side::kLeft, gzip("a")}}, {{soccer::Side::kRight, gzip("b")}}}};
  const std::string page = compare_page(a.record, a.compared(), b.record, b.compared(), drawings);
  EXPECT_EQ(tests::count(page, "id=\"drawings-left\""), 1U);
  EXPECT_EQ(tests::count(page, "id=\"other-drawings-right\""), 1U);
  EXPECT_EQ(tests::record_difference(a.record, read_page(page)), "");
  EXPECT_EQ(tests::count(page, "id=\"other\""), 1U);
  EXPECT_THAT(page, HasSubstr("(frame 100): ball position"));
}

TEST(ComparePage, ShowsNamesAsText) {
  for (const std::string name : {"</script><script>alert(1)</script>", "<!--", "\xff\x01\""}) {
    Match a(record_of("rcg-v6-excerpt"));
    a.summary.file = name;
    a.summary.teams[0].name = name;
    const std::string page = compare_page(a.record, a.compared(), a.record, a.compared());
    EXPECT_EQ(tests::count(page, "<script"), 5U);
    EXPECT_EQ(tests::count(page, "</script"), 5U);
    EXPECT_TRUE(read_page(page));
  }
}

}  // namespace
}  // namespace cls::viewer
