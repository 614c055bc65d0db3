// Prints what distinguishes two matches, and writes their page.
#include "cli/logs/compare_matches.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/printable.h"
#include "base/text/table.h"
#include "cli/logs/analyzed_match.h"
#include "cli/support/browser.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "viewer/page/page_drawings.h"
#include "viewer/report/compare_page.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

using TableRows = std::vector<std::vector<std::string>>;

std::string table_text(const TableRows& rows) {
  base::Table table;
  for (const std::string& heading : rows.front()) {
    table.add_column(heading,
                     heading.empty() ? base::Table::Align::kLeft : base::Table::Align::kRight);
  }

  for (std::size_t i = 1; i < rows.size(); ++i) table.add_row(rows[i]);
  return table.format_text({2, stdout_width()});
}

std::string events_text(const std::vector<viewer::LoneEvent>& events) {
  constexpr std::size_t kShown = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, events.size()); ++i) {
    text += fmt::format("  {:>6}  only {}  {}\n", events[i].cycle, events[i].match == 0 ? 'A' : 'B',
                        events[i].text);
  }

  if (events.size() > kShown) {
    text += fmt::format("  and {} more, in the page\n", events.size() - kShown);
  }
  return text;
}

base::Json difference_document(const std::optional<viewer::FrameDifference>& first,
                               const std::vector<viewer::LoneEvent>& events, const fs::path& page) {
  using base::Json;
  Json document = {{"schema", "cls.watch/1"}, {"page", page.string()}, {"equal", !first}};

  document["first_difference"] = nullptr;
  if (first) {
    document["first_difference"] = {{"frame", first->frame},
                                    {"cycle", first->cycle},
                                    {"stopped", first->stopped},
                                    {"what", first->what}};
  }

  document["events"] = Json::array();
  for (const viewer::LoneEvent& event : events) {
    document["events"].push_back(
        {{"only", event.match == 0 ? "a" : "b"}, {"cycle", event.cycle}, {"event", event.text}});
  }

  return document;
}

void print_differences(const CompareArguments& arguments, const AnalyzedMatch& a,
                       const AnalyzedMatch& b, const fs::path& page) {
  const auto first = viewer::first_difference(a.match.record, b.match.record);
  const auto events = viewer::lone_events(a.statistics, b.statistics);
  if (arguments.json) {
    print_json(difference_document(first, events, page));
    return;
  }

  fmt::print("A: {}\nB: {}\nfirst different frame: {}\n", arguments.first, arguments.second,
             viewer::difference_text(first));
  if (first) {
    fmt::print("\n{}", base::printable_lines(table_text(viewer::difference_rows(
                           {&a.summary, &a.statistics}, {&b.summary, &b.statistics}))));
  }

  if (!events.empty()) {
    fmt::print("\ngoals, shots and fouls of one match only\n{}",
               base::printable_lines(events_text(events)));
  }

  fmt::print("\n{}\n", arguments.out.empty() ? file_url(page) : page.string());
}

}  // namespace

int compare_matches(const CompareArguments& arguments) {
  AnalyzedMatch a;
  AnalyzedMatch b;

  TRY_STEP(read_match(arguments.first, a));
  TRY_STEP(read_match(arguments.second, b));

  // The logs of match folders all have the same name.
  a.summary.file = arguments.first;
  b.summary.file = arguments.second;

  const fs::path page =
      arguments.out.empty() ? a.found.folder / "compare.html" : fs::path(arguments.out);
  if (const auto why = why_no_page(page)) return print_error(kCannotCreate, *why);

  const std::string text = viewer::compare_page(
      a.match.record, {&a.summary, &a.statistics}, b.match.record, {&b.summary, &b.statistics},
      {viewer::read_page_drawings(a.found.folder), viewer::read_page_drawings(b.found.folder)});
  TRY_OR(kCannotCreate, write_beside(page, text, arguments.out));

  print_differences(arguments, a, b, page);
  if (arguments.out.empty() && !arguments.no_open) open_in_browser(file_url(page));

  const bool clean = a.match.record.errors.empty() && b.match.record.errors.empty();
  return clean ? kOk : kBadData;
}

}  // namespace cls::cli
