// Tables as text, Markdown, CSV and HTML.
#include "base/text/table.h"

#include <gtest/gtest.h>

namespace cls::base {
namespace {

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

TEST(Table, EscapesHtml) {
  Table table;
  table.add_column("<a>");
  table.add_column("n", Table::Align::kRight);
  table.add_row({"x & y", "1"});
  EXPECT_EQ(table.format_html(),
            "<table>\n<tr><th class=\"w\">&lt;a&gt;</th><th>n</th></tr>\n"
            "<tr><td class=\"w\">x &amp; y</td><td>1</td></tr>\n</table>\n");
}

TEST(Table, AppendsRowsOfAnotherTable) {
  Table table = example();
  table.append_rows(example());
  EXPECT_EQ(table.format_csv(),
            "team,goals,diff\n\xc3\x9c,4:2,+2\na_b|c,2:4,\n\xc3\x9c,4:2,+2\na_b|c,2:4,\n");
  EXPECT_TRUE(Table().empty());
  EXPECT_FALSE(table.empty());
}

}  // namespace
}  // namespace cls::base
