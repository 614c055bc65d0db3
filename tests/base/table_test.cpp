// Tables as text, Markdown, CSV and HTML.
#include "base/text/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cls::base {
namespace {

using testing::HasSubstr;

Table example() {
  Table table;
  table.add_column("team");
  table.add_columns({"goals", "diff"}, Table::Align::kRight);
  table.add_row({"\xc3\x9c", "4:2", "+2"});
  table.add_row({"a_b|c", "2:4", ""});
  return table;
}

TEST(Table, AlignsColumnsByCharactersNotBytes) {
  EXPECT_EQ(example().format_text(),
            "team   goals  diff\n"
            "\xc3\x9c        4:2    +2\n"
            "a_b|c    2:4\n");
  EXPECT_EQ(example().format_text(2).substr(0, 7), "  team ");
}

TEST(Table, ReplacesControlCharactersInText) {
  Table table;
  table.add_column("a");
  table.add_row({"x\x1b[31m\ny"});
  EXPECT_EQ(table.format_text(), "a\nx?[31m?y\n");
  EXPECT_EQ(table.format_csv(), "a\nx?[31m?y\n");
  EXPECT_EQ(table.format_markdown(), "| a |\n|---|\n| x?\\[31m y |\n");
}

TEST(Table, EscapesMarkdownByStyle) {
  EXPECT_EQ(example().format_markdown(),
            "| team | goals | diff |\n|---|--:|--:|\n"
            "| \xc3\x9c | 4:2 | +2 |\n| a\\_b\\|c | 2:4 |  |\n");
  EXPECT_EQ(example().format_markdown({"|", "|", "---:"}),
            "| team | goals | diff |\n|---|---:|---:|\n"
            "| \xc3\x9c | 4:2 | +2 |\n| a_b\\|c | 2:4 |  |\n");
}

TEST(Table, QuotesCsvCellsWhereNecessary) {
  Table table;
  table.add_columns({"a,b", "c"});
  table.add_row({"say \"x\"", "plain"});
  EXPECT_EQ(table.format_csv(), "\"a,b\",c\n\"say \"\"x\"\"\",plain\n");
}

TEST(Table, GuardsCsvCellsAgainstFormulas) {
  Table table;
  table.add_columns({"team", "x"});

  for (const char* cell : {"=cmd|'/C calc'!A0", "+1+1", "-2+3", "@SUM(A1)", "\t=1"}) {
    table.add_row({cell, "1"});
  }
  for (const char* cell : {"-3", "+12", "-1.5e-3", "+0.25", "-", "+", "a=b"}) {
    table.add_row({cell, "1"});
  }
  EXPECT_EQ(table.format_csv(),
            "team,x\n'=cmd|'/C calc'!A0,1\n'+1+1,1\n'-2+3,1\n'@SUM(A1),1\n =1,1\n"
            "-3,1\n+12,1\n-1.5e-3,1\n+0.25,1\n-,1\n+,1\na=b,1\n");
}

TEST(Table, EscapesHtml) {
  Table table;
  table.add_column("<a>");
  table.add_column("n", Table::Align::kRight);
  table.add_row({"x & y", "1"});

  EXPECT_EQ(table.format_html(),
            "<table>\n<thead><tr><th scope=\"col\" class=\"w\">&lt;a&gt;</th>"
            "<th scope=\"col\">n</th></tr></thead>\n<tbody>\n"
            "<tr><th scope=\"row\" class=\"w\">x &amp; y</th><td>1</td></tr>\n"
            "</tbody>\n</table>\n");
  EXPECT_THAT(table.format_html("a < b"),
              HasSubstr("<table>\n<caption>a &lt; b</caption>\n<thead>"));
}

TEST(Table, HasNoHtmlHeadingWithoutText) {
  Table table;
  table.add_columns({"", "a"});
  EXPECT_THAT(table.format_html(),
              HasSubstr("<tr><td></td><th scope=\"col\" class=\"w\">a</th></tr>"));
}

TEST(Table, LinksCellsInMarkdownAndHtml) {
  Table table;
  table.add_columns({"match", "logs"});
  table.add_row({"1", "folder"});
  table.add_row({"2", "folder"});
  table.link_last_row(1, "matches/2/?a&b");

  EXPECT_EQ(table.format_markdown(),
            "| match | logs |\n|---|---|\n| 1 | folder |\n| 2 | [folder](matches/2/?a&b) |\n");
  EXPECT_THAT(table.format_html(), HasSubstr("<a href=\"matches/2/?a&amp;b\">folder</a>"));
  EXPECT_EQ(table.format_csv(), "match,logs\n1,folder\n2,folder\n");
}

TEST(Table, SplitsColumnsIntoBlocksWithinWidth) {
  Table table;
  table.add_columns({"team", "aaaa", "bbbb", "cccc"});
  table.add_row({"X", "1", "2", "3"});

  EXPECT_EQ(table.format_text({1, 17}),
            " team  aaaa  bbbb\n X     1     2\n\n team  cccc\n X     3\n");
  EXPECT_EQ(table.format_text({0, 22}), "team  aaaa  bbbb  cccc\nX     1     2     3\n");
  EXPECT_EQ(table.format_text({0, 4}),
            "team\nX\n\nteam  aaaa\nX     1\n\nteam  bbbb\nX     2\n\nteam  cccc\nX     3\n")
      << "a column may be wider than the line";
}

TEST(Table, CutsCellsWhereAllowedBeforeItSplits) {
  Table table;
  table.add_columns({"team", "goals", "log"});
  table.allow_cuts(1);
  table.add_row({"X", "1247 r 10; 3243 l 9", "a.rcg"});
  table.add_row({"Y", "\xc3\xb6\xc3\xb6\xc3\xb6\xc3\xb6 1247 r 10; 3", "b.rcg"});

  EXPECT_EQ(table.format_text({0, 26}),
            "team  goals          log\n"
            "X     1247 r 10;...  a.rcg\n"
            "Y     \xc3\xb6\xc3\xb6\xc3\xb6\xc3\xb6 1247 ...  b.rcg\n");

  for (const std::size_t width : {0U, 22U}) {
    EXPECT_THAT(table.format_text({0, width}), HasSubstr("1247 r 10; 3243 l 9"))
        << "where cuts do not suffice, blocks show everything";
  }
}

TEST(Table, AppendsRowsOfAnotherTable) {
  Table table = example();
  table.append_rows(example());
  EXPECT_EQ(table.format_csv(),
            "team,goals,diff\n\xc3\x9c,4:2,+2\na_b|c,2:4,\n\xc3\x9c,4:2,+2\na_b|c,2:4,\n");
  EXPECT_TRUE(Table().empty());
  EXPECT_FALSE(table.empty());
}

TEST(Table, FoldsCellsOfAColumnThatMayFold) {
  Table table;
  table.add_columns({"name", "meaning"});
  table.add_row({"ball", "where the ball was seen by the agent"});
  table.add_row({"unum", "its number"});
  table.allow_folds(1);

  EXPECT_EQ(table.format_text({0, 26, 1}),
            "name  meaning\n"
            "ball  where the ball was\n"
            "      seen by the agent\n"
            "unum  its number\n");
  EXPECT_EQ(table.format_text(),
            "name  meaning\n"
            "ball  where the ball was seen by the agent\n"
            "unum  its number\n");
}

}  // namespace
}  // namespace cls::base
