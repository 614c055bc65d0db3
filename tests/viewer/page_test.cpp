// Pages: what they contain, what comes back, and what names of teams may not do.
#include "viewer/page/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <string>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/gamelog/recorded_match.h"
#include "tests/support/error_of.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/markup.h"
#include "tests/viewer/record_difference.h"
#include "viewer/decisions/decision_files.h"
#include "viewer/page/encoding.h"
#include "viewer/page/match_page.h"
#include "viewer/page/page_drawings.h"
#include "viewer/page/viewer_program.h"

namespace cls::viewer {
namespace {

using testing::HasSubstr;
using testing::Not;
using tests::count;
using tests::record_of;

std::string page_of(const gamelog::MatchRecord& record, bool compact = false) {
  return match_page(record, nullptr, "game.rcg",
                    {.settings = {1234, {"l7", "r1"}}, .compact = compact});
}

std::string error_of(std::string_view page) { return tests::error_of(read_page(page)); }

TEST(Encoding, MatchesKnownValues) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(from_base64(" Zm9v\nYg== ").value(), "foob");
  EXPECT_EQ(from_base64("Zm9<").error().message, "no base64 at character 4 of the match");
  EXPECT_EQ(csp_hash(""), "'sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU='");
  EXPECT_EQ(gunzip(gzip("abc"), 3).value(), "abc");
  EXPECT_EQ(gunzip(gzip("abcd"), 3).error().message, "the match is too large");
  EXPECT_FALSE(gunzip("abc", 100));
}

TEST(Page, GivesTheRecordBack) {
  for (const char* name : {"rcg-v1-excerpt", "rcg-v3-excerpt", "match-start", "rcg-json-excerpt"}) {
    SCOPED_TRACE(name);
    const gamelog::MatchRecord record = record_of(name);
    const auto match = read_page(page_of(record));
    ASSERT_EQ(tests::record_difference(record, match), "");
    EXPECT_THAT(match->statistics, HasSubstr("\"possession\""));
    EXPECT_THAT(match->statistics, HasSubstr("\"events\""));
  }
}

TEST(Page, ReadsFilesOfBothKinds) {
  const tests::TemporaryFolder folder;
  const gamelog::MatchRecord record = record_of("rcg-v6-excerpt");
  const std::string path = folder.path() / "page.html";
  std::ofstream(path) << page_of(record);
  const auto page = read_log_or_page(path);
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_TRUE(page->from_page);
  EXPECT_EQ(tests::record_difference(record, page->record), "");
  const auto log = read_log_or_page(tests::fixture("gamelog/rcg-v6-excerpt.rcg.gz").string());
  ASSERT_TRUE(log) << log.error().message;
  EXPECT_FALSE(log->from_page);
  EXPECT_EQ(tests::record_difference(record, log->record), "");
}

TEST(Page, AllowsItsOwnProgramOnly) {
  const std::string page = page_of(record_of("rcg-v6-excerpt"));
  const std::string script = "<script>" + std::string(viewer_script()) + "</script>";
  const std::string style = "<style>" + std::string(viewer_style()) + "</style>";
  EXPECT_THAT(page, HasSubstr(script));
  EXPECT_THAT(page, HasSubstr(style));
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src " + csp_hash(viewer_script()) +
                              "; style-src " + csp_hash(viewer_style()) + "; img-src data: blob:"));
  EXPECT_THAT(page, Not(HasSubstr("unsafe-")));
  EXPECT_EQ(count(page, "<script"), 3U);
  EXPECT_EQ(count(page, "<style"), 1U);
  EXPECT_THAT(page, HasSubstr(R"("at":1234,"players":["l7","r1"])"));
}

TEST(Page, EmbedsAProgramThatCannotEndEarly) {
  for (const std::string_view text : {viewer_script(), debugger_script(), viewer_style()}) {
    EXPECT_GT(text.size(), 1000U);
    EXPECT_THAT(text, Not(HasSubstr("</script")));
    EXPECT_THAT(text, Not(HasSubstr("</style")));
    EXPECT_THAT(text, Not(HasSubstr("<!--")));
  }
  EXPECT_FALSE(std::regex_search(std::string(viewer_script()), std::regex("\n(import|export) ")));
}

TEST(Page, HasTheDecisionDebuggerWithDecisionsOnly) {
  constexpr std::string_view kDebugger = "class DecisionPanel";
  EXPECT_THAT(viewer_script(), Not(HasSubstr(kDebugger)));
  EXPECT_THAT(debugger_script(), HasSubstr(kDebugger));
  const analysis::MatchSummary summary;
  const std::string without = write_page(summary, "stream", {});
  const std::string with =
      write_page(summary, "stream", {}, {{soccer::Side::kRight, gzip("decisions")}});
  EXPECT_THAT(without, Not(HasSubstr(kDebugger)));
  EXPECT_THAT(without, Not(HasSubstr("id=\"decisions-")));
  EXPECT_THAT(with, HasSubstr("script-src " + csp_hash(debugger_script())));
  EXPECT_THAT(with, HasSubstr("id=\"decisions-right\" data-length=\""));
  EXPECT_THAT(with, HasSubstr(base64(gzip("decisions"))));
}

TEST(Page, ShowsNamesAsText) {
  for (const std::string name : {"</script><script>alert(1)</script>", "</noscript><img src=x>",
                                 "\"'><b>", "</title><h1>", "<!--", "\xff\xfe\x01", "&lt;b&gt;"}) {
    SCOPED_TRACE(name);
    gamelog::MatchRecord record = record_of("rcg-v6-excerpt");
    for (auto& [left, right] : record.teams) left.name = name;
    for (gamelog::Note& note : record.notes) {
      if (auto* teams = std::get_if<gamelog::TeamFrames>(&note.content)) (*teams)[0].name = name;
      if (auto* message = std::get_if<gamelog::Message>(&note.content)) message->text = name;
    }
    const std::string page = match_page(record, nullptr, name, {.settings = {0, {name}}});

    EXPECT_EQ(count(page, "<script"), 3U);
    EXPECT_EQ(count(page, "</script"), 3U);
    EXPECT_EQ(count(page, "</noscript"), 1U);
    EXPECT_EQ(count(page, "</title"), 1U);
    EXPECT_EQ(count(page, "<img"), 0U);
    EXPECT_EQ(error_of(page), "");
  }
}

TEST(Page, HasTheTextsAndDrawingsOfItsMatchFolder) {
  const tests::TemporaryFolder folder;
  const std::string lines = "{\"t\":5,\"unum\":3,\"kind\":\"text\",\"message\":\"<b>\"}\n";
  std::ofstream(folder.path() / kRightDebugFile) << lines;
  std::ofstream(folder.path() / kLeftDebugFile) << "";
  PageSettings settings;
  settings.drawings = read_page_drawings(folder.path());

  ASSERT_EQ(settings.drawings.size(), 1U);
  EXPECT_EQ(gunzip(settings.drawings[0].packed, 1000).value(), lines);

  const gamelog::MatchRecord record = record_of("rcg-v6-excerpt");
  const std::string page = match_page(record, nullptr, "game.rcg", {.settings = settings});
  EXPECT_EQ(count(page, "id=\"drawings-right\""), 1U);
  EXPECT_EQ(count(page, "id=\"drawings-left\""), 0U);
  EXPECT_EQ(count(page, "class DrawingStore"), 1U);
  EXPECT_EQ(error_of(page), "");
  EXPECT_EQ(count(page_of(record), "class DrawingStore"), 0U);
}

TEST(Page, SaysHowMuchIsThere) {
  const std::string page = page_of(record_of("rcg-v6-excerpt"));
  const std::size_t data = page.find("data-length=");
  const std::size_t start = page.find("\">", data) + 2;
  const std::size_t length = page.find("</script>", start) - start;
  EXPECT_EQ(error_of(page.substr(0, start + length * 61 / 100 + 1)),
            "truncated: 61 % of the match is there");
  EXPECT_EQ(error_of(page.substr(0, data)), "an HTML page without a match of cls");
  EXPECT_EQ(error_of("<!doctype html><p>x"), "an HTML page without a match of cls");
  std::string changed = page;
  changed[start + length / 2] = changed[start + length / 2] == 'A' ? 'B' : 'A';
  EXPECT_NE(error_of(changed), "");
}

TEST(Page, OfAWholeMatchIsSmall) {
  const auto path = tests::data("logs/helios-vs-helios-full.rcg.gz");
  if (!path) GTEST_SKIP() << "no data: set CLS_DATA";
  const gamelog::MatchRecord record = gamelog::read_rcg_file(path->string()).value();
  EXPECT_LE(page_of(record).size(), 1'700'000U);
  EXPECT_LE(page_of(record, true).size(), 900'000U);
}

}  // namespace
}  // namespace cls::viewer
