// `cls explain`: the reference in the terminal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/number_text.h"
#include "base/text/suggestion.h"
#include "base/text/table.h"
#include "base/text/wrap_text.h"
#include "cli/explain/decision_report.h"
#include "cli/explain/formation_picture.h"
#include "cli/explain/reference.h"
#include "cli/explain/table_rows.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/terminal.h"
#include "soccer/geometry.h"
#include "soccer/side.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Json;

// The word that names all rows of the tables.
constexpr const char* kAllRows = "summary";

constexpr const char* kExplainDescription =
    "explain a field, an action, a play mode or an end reason\n"
    "\n"
    "  cls explain body_smart_kick     what it does, ends in, and when it fails\n"
    "  cls explain Self.stamina        unit and range of a field\n"
    "  cls explain offside_line_x      in whatever message it is\n"
    "  cls explain Ball                a message with its fields\n"
    "  cls explain KickIn_ stalled     a play mode and an end reason\n"
    "  cls explain missed              a row of the tables that commands print\n"
    "  cls explain summary             all of these rows\n"
    "  cls explain formation           a picture of the home positions\n"
    "  cls explain formation offense --ball=20,10 --svg offense.svg\n"
    "  cls explain decision match      what players chose, and what else was best\n"
    "  cls explain decision match --at 371 --side left --player 9\n"
    "                                  all that a player considered (cls match\n"
    "                                  --record-world-models)\n"
    "  cls explain --search offside    names whose explanation has the text\n"
    "  cls explain --list              all names";

struct ExplainArguments {
  std::vector<std::string> names;
  std::string folder;
  std::string search;
  std::string ball = "0,0";
  std::string svg;
  DecisionQuestion decision;
  bool list = false;
  bool json = false;
};

// For a terminal: no marks of code, links without targets.
std::string plain(std::string_view text) {
  static const std::regex link(R"(\[([^\]\n]+)\]\([^)\n]*\))");
  std::string result = std::regex_replace(std::string(text), link, "$1");
  std::erase(result, '`');
  return result;
}

std::vector<const ReferenceEntry*> members_of(const ReferenceEntry& entry) {
  const std::string_view message =
      entry.kind == ReferenceKind::kAction ? fact(entry, "message") : std::string_view(entry.name);

  std::vector<const ReferenceEntry*> members;
  for (const ReferenceEntry& one : reference()) {
    if (one.kind != ReferenceKind::kAction && one.group == message) members.push_back(&one);
  }
  return members;
}

std::string own_name(const ReferenceEntry& entry) {
  return entry.name.substr(entry.name.rfind('.') + 1);
}

bool has_members(const ReferenceEntry& entry) {
  return entry.kind == ReferenceKind::kMessage || entry.kind == ReferenceKind::kEnum ||
         entry.kind == ReferenceKind::kAction;
}

// A line for the name of each member, its meaning below it.
std::string members_list(const std::vector<const ReferenceEntry*>& members) {
  constexpr std::size_t kMeaningIndent = 6;
  std::string text;
  for (const ReferenceEntry* one : members) {
    text += "  " + own_name(*one);
    for (const char* label : {"type", "unit"}) {
      const std::string_view value = fact(*one, label);
      if (!value.empty()) fmt::format_to(std::back_inserter(text), ", {}", value);
    }

    text += '\n';
    if (one->text.empty()) continue;
    fmt::format_to(std::back_inserter(text), "{:{}}{}\n", "", kMeaningIndent,
                   base::wrap_text(plain(one->text), stdout_width(), kMeaningIndent));
  }
  return text;
}

// A table, or a list where the table has no room for meanings.
std::string members_text(const ReferenceEntry& entry) {
  constexpr std::size_t kLeastMeaning = 24;
  constexpr std::size_t kGaps = 2 + 3 * 2;
  const std::vector<const ReferenceEntry*> members = members_of(entry);
  base::Table table;
  table.add_columns({"name", "type", "unit", "meaning"});
  std::array<std::size_t, 3> widths = {4, 4, 4};
  for (const ReferenceEntry* one : members) {
    const std::string type(fact(*one, "type"));
    const std::string unit(fact(*one, "unit"));
    table.add_row({own_name(*one), type, unit, plain(one->text)});
    widths = {std::max(widths[0], own_name(*one).size()), std::max(widths[1], type.size()),
              std::max(widths[2], unit.size())};
  }

  const std::size_t taken = widths[0] + widths[1] + widths[2] + kGaps;
  if (taken + kLeastMeaning > stdout_width()) return members_list(members);
  table.allow_folds(3);
  return table.format_text({2, stdout_width(), 1});
}

void print(const ReferenceEntry& entry, bool color) {
  const std::size_t width = stdout_width();
  const std::string of = entry.kind == ReferenceKind::kAction ? " of a " + entry.group
                         : entry.group.empty()                ? ""
                                                              : " of " + entry.group;

  fmt::print("{}{}{} ({}{})\n", color ? "\x1b[1m" : "", entry.name, color ? "\x1b[0m" : "",
             name(entry.kind), of);
  if (!entry.text.empty()) {
    fmt::print("  {}\n", base::wrap_text(plain(entry.text), width, 2));
  }

  for (const auto& [label, value] : entry.facts) {
    fmt::print("  {:<11} {}\n", label, base::wrap_text(plain(value), width, 14));
  }

  fmt::print("  {:<11} docs/reference/{}\n", "see", page_of(entry));
  if (has_members(entry) && !members_of(entry).empty()) fmt::print("\n{}", members_text(entry));
}

Json json_of(const std::vector<const ReferenceEntry*>& entries) {
  Json list = Json::array();
  for (const ReferenceEntry* entry : entries) {
    Json one = {{"kind", name(entry->kind)}, {"name", entry->name}, {"text", entry->text}};
    one["group"] = entry->group.empty() ? Json(nullptr) : Json(entry->group);
    one["page"] = page_of(*entry);
    one["facts"] = Json::object();
    for (const auto& [label, value] : entry->facts) one["facts"][label] = value;

    one["members"] = Json::array();
    if (has_members(*entry)) {
      for (const ReferenceEntry* member : members_of(*entry))
        one["members"].push_back(member->name);
    }

    list.push_back(std::move(one));
  }
  return list;
}

Json json_of(const std::vector<const TableRow*>& rows) {
  Json list = Json::array();
  for (const TableRow* row : rows) {
    list.push_back({{"command", row->command}, {"row", row->label}, {"meaning", row->meaning}});
  }
  return list;
}

Json document(const std::vector<const ReferenceEntry*>& entries,
              const std::vector<const TableRow*>& rows = {}) {
  return {{"schema", "cls.explain/1"}, {"entries", json_of(entries)}, {"rows", json_of(rows)}};
}

int list(bool json) {
  std::vector<const ReferenceEntry*> all;
  for (const ReferenceEntry& entry : reference()) all.push_back(&entry);

  if (json) {
    return print_json(document(all));
  }

  for (const ReferenceEntry* entry : all) fmt::print("{:<11} {}\n", name(entry->kind), entry->name);
  return kOk;
}

int search(const std::string& text, bool json) {
  const auto found = entries_with(text);

  if (json) {
    return print_json(document(found));
  }

  if (found.empty()) return print_error(kUsage, "nothing explains '{}'", text);
  base::Table table;
  table.add_columns({"kind", "name", "meaning"});
  for (const ReferenceEntry* entry : found) {
    table.add_row({std::string(name(entry->kind)), entry->name, plain(meaning(*entry))});
  }

  table.allow_folds(2);
  fmt::print("{}", table.format_text({0, stdout_width(), 1}));
  return kOk;
}

int export_pages(const std::string& folder, bool json) {
  TRY_OR(kCannotCreate, base::create_folders(folder));

  Json files = Json::array();
  for (const auto& [file, text] : reference_pages()) {
    const std::string path = (fs::path(folder) / file).string();
    TRY_OR(kWriteFailed, base::write_file(path, text));
    if (!json) fmt::print("{}\n", path);
    files.push_back(path);
  }

  if (json) {
    print_json({{"schema", "cls.explain/1"}, {"files", files}});
  }

  return kOk;
}

std::string rows_text(const std::vector<const TableRow*>& rows) {
  base::Table table;
  table.add_columns({"printed by", "row", "meaning"});
  for (const TableRow* row : rows) {
    table.add_row({std::string(row->command), std::string(row->label), std::string(row->meaning)});
  }
  table.allow_folds(2);
  return table.format_text({0, stdout_width(), 1});
}

int report_unknown(const std::string& word) {
  std::vector<std::string_view> names;
  for (const TableRow& row : table_rows()) names.push_back(row.label);
  for (const ReferenceEntry& entry : reference()) {
    names.emplace_back(entry.name);
    if (entry.kind == ReferenceKind::kField) {
      names.push_back(std::string_view(entry.name).substr(entry.name.rfind('.') + 1));
    }
  }

  const std::string near = base::did_you_mean(word, names);
  return print_error(kUsage, "unknown name '{}'{}", word,
                     near.empty() ? " (see cls explain --list)" : near);
}

// "20,-5.5"
std::optional<soccer::Vec2> parse_place(std::string_view text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto x = base::parse_number(text.substr(0, comma));
  const auto y = comma < text.size() ? base::parse_number(text.substr(comma + 1)) : std::nullopt;
  if (!x || !y) return std::nullopt;
  return soccer::Vec2{*x, *y};
}

int explain_formation(const ExplainArguments& arguments) {
  const auto ball = parse_place(arguments.ball);
  if (!ball) {
    return print_error(kUsage,
                       "--ball '{}': must be X,Y in meters, such as "
                       "--ball=-20,5",
                       arguments.ball);
  }
  const std::string name = arguments.names.size() > 1 ? arguments.names[1] : "normal-formation";
  TRY_INIT_OR(kUsage, const auto picture, find_formation(name, *ball));

  if (!arguments.svg.empty()) {
    TRY_OR(kCannotCreate, base::write_file(arguments.svg, formation_svg(picture)));
  }

  if (arguments.json) {
    Json places = Json::array();
    for (const soccer::Vec2 at : picture.players) places.push_back({at.x, at.y});
    print_json({{"schema", "cls.formation/1"},
                {"name", picture.name},
                {"ball", {picture.ball.x, picture.ball.y}},
                {"players", std::move(places)}});
  } else if (!arguments.svg.empty()) {
    fmt::print("{}\n", arguments.svg);
  } else {
    fmt::print(
        "{}\nothers: {}\n", formation_text(picture, stdout_width()),
        base::wrap_text(fmt::format("{}", fmt::join(formation_names(), ", ")), stdout_width(), 8));
  }

  return kOk;
}

int explain_decision_of(const ExplainArguments& arguments) {
  if (arguments.names.size() != 2) {
    return print_error(kUsage, "explain decision: name the folder of one match");
  }
  DecisionQuestion question = arguments.decision;
  question.folder = arguments.names[1];
  return explain_decision(question, arguments.json);
}

// Adds what `word` names; whether there is anything. A name of the interface names only the rows
// with this label.
bool find_word(const std::string& word, std::vector<const ReferenceEntry*>& entries,
               std::vector<const TableRow*>& rows) {
  if (word == kAllRows) {
    for (const TableRow& row : table_rows()) rows.push_back(&row);
    return true;
  }

  const auto named = find_entries(word);
  const auto labels = named.empty() ? find_rows(word) : rows_with_label(word);
  entries.insert(entries.end(), named.begin(), named.end());
  rows.insert(rows.end(), labels.begin(), labels.end());
  return !named.empty() || !labels.empty();
}

int run_explain(const ExplainArguments& arguments) {
  if (!arguments.folder.empty()) return export_pages(arguments.folder, arguments.json);
  if (arguments.list) return list(arguments.json);
  if (!arguments.search.empty()) return search(arguments.search, arguments.json);
  if (arguments.names.empty())
    return print_error(kUsage, "explain: NAME is missing (see cls explain --list)");

  const bool formation = arguments.names[0] == "formation" || arguments.names[0] == "formations";
  if (formation) return explain_formation(arguments);
  if (arguments.names[0] == "decision") return explain_decision_of(arguments);

  std::vector<const ReferenceEntry*> entries;
  std::vector<const TableRow*> rows;
  for (const std::string& word : arguments.names) {
    if (!find_word(word, entries, rows)) return report_unknown(word);
  }
  if (arguments.json) return print_json(document(entries, rows));

  const bool color = stdout_supports_color();
  for (const ReferenceEntry* entry : entries) {
    if (entry != entries.front()) fmt::print("\n");
    print(*entry, color);
  }
  if (!rows.empty()) fmt::print("{}{}", entries.empty() ? "" : "\n", rows_text(rows));
  return kOk;
}

}  // namespace

void add_explain_command(Command& app) {
  auto [command, arguments] = app.command("explain", kExplainDescription, run_explain);

  command.option(
      "NAME", arguments.names,
      "a name of the interface, or its last part; a row of a table; summary; formation, and\n"
      "which one; decision, and the folder of a match");
  command.flag("--list", arguments.list, "print all names");
  command.setting("--ball", arguments.ball, "where the ball is, of a formation").placeholder("X,Y");
  command.option("--svg", arguments.svg, "write the picture of a formation to this file");
  command.option("--at", arguments.decision.cycle, "only decisions of this cycle")
      .placeholder("CYCLE");
  command.option("--side SIDE", arguments.decision.side, "only decisions of left or right")
      .one_of({"left", "right"});
  command.option("--player", arguments.decision.unum, "only decisions of this player")
      .range(1, soccer::kPlayersPerTeam);
  command.option("--search", arguments.search, "list the entries with a text").placeholder("WORDS");
  command.option("--export DIR", arguments.folder, "write the pages of docs/reference to a folder");

  command.flag("--json", arguments.json, "print one JSON document").of_group(kOutputGroup);
}

}  // namespace cls::cli
