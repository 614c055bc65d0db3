// docs/reference/ as Markdown.
#include <fmt/format.h>

#include <cctype>
#include <iterator>
#include <regex>
#include <set>

#include "base/text/table.h"
#include "cli/explain/parameter_facts.h"
#include "cli/explain/reference.h"

namespace cls::cli {
namespace {

constexpr const char* kGenerated =
    "<!-- Written by `cls explain --export docs/reference`. Change proto/*.proto,\n"
    "     docs/actions.md, docs/troubleshooting.md or cli/explain/*.toml instead. -->\n";

constexpr std::string_view kModeEnum = "GameModeType";

// Readable as text, too: names are code, in which nothing is escaped.
constexpr base::MarkdownStyle kStyle = {"|", "|", "--:"};

std::string code(std::string_view text) { return text.empty() ? "" : fmt::format("`{}`", text); }

const ReferenceEntry* find(ReferenceKind kind, std::string_view name) {
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind == kind && entry.name == name) return &entry;
  }
  return nullptr;
}

std::string fields_of(std::string_view message) {
  std::vector<const ReferenceEntry*> fields;
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind == ReferenceKind::kField && entry.group == message) fields.push_back(&entry);
  }

  if (fields.empty()) return {};

  std::vector<std::string_view> labels = {"type"};
  for (const char* label : {"unit", "range", "default", "unknown", "set", "setting"}) {
    for (const ReferenceEntry* field : fields) {
      if (fact(*field, label).empty()) continue;
      labels.emplace_back(label);
      break;
    }
  }

  base::Table table;
  table.add_column("field");
  table.add_columns(labels);
  table.add_column("meaning");
  for (const ReferenceEntry* field : fields) {
    std::vector<std::string> cells = {code(field->name.substr(field->name.rfind('.') + 1)),
                                      code(fact(*field, "type"))};
    for (const std::string_view label : labels) {
      if (label != "type") cells.emplace_back(fact(*field, label));
    }
    cells.push_back(field->text);
    table.add_row(std::move(cells));
  }

  return table.format_markdown(kStyle);
}

std::string messages_page() {
  std::string text = fmt::format("# Messages\n\n{}\n", kGenerated);

  text +=
      "The messages of [playmaker.proto](../../proto/playmaker.proto), but for "
      "[actions](actions.md) and\n"
      "[parameters](parameters.md), and at the end those of "
      "[team_playmaker.proto](../../proto/team_playmaker.proto)\n"
      "([wire.md](../wire.md)). Lengths are in meters, angles in degrees with 0 along +x and "
      "positive\n"
      "toward +y, in the coordinates of the agent's own team, which attacks toward +x. *unknown* "
      "is the value\n"
      "of a field that is not known; *set* says when a field is set, where that is not always.\n";

  std::set<std::string_view> actions;
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind == ReferenceKind::kAction) actions.insert(fact(entry, "message"));
  }

  for (const ReferenceEntry& entry : reference()) {
    const bool is_block =
        entry.kind == ReferenceKind::kMessage || entry.kind == ReferenceKind::kEnum;
    if (!is_block || is_parameter_message(entry.name) || actions.contains(entry.name)) continue;
    if (entry.name == kModeEnum) continue;

    fmt::format_to(std::back_inserter(text), "\n## {}\n", entry.name);
    if (!entry.text.empty()) fmt::format_to(std::back_inserter(text), "\n{}\n", entry.text);
    if (entry.kind == ReferenceKind::kMessage) {
      const std::string fields = fields_of(entry.name);
      if (!fields.empty()) text += "\n" + fields;
      continue;
    }

    base::Table table;
    table.add_columns({"value", "number", "meaning"});
    for (const ReferenceEntry& value : reference()) {
      if (value.kind != ReferenceKind::kValue || value.group != entry.name) continue;
      table.add_row({code(value.name), std::string(fact(value, "number")), value.text});
    }

    text += "\n" + table.format_markdown(kStyle);
  }
  return text;
}

std::string actions_page() {
  std::string text = fmt::format("# Actions\n\n{}\n", kGenerated);
  text +=
      "Every action of a reply, with the fields of its message. [actions.md](../actions.md) "
      "describes how the\n"
      "proxy tries a list of actions.\n";
  std::string_view agent;
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind != ReferenceKind::kAction) continue;

    if (entry.group != agent) {
      agent = entry.group;
      fmt::format_to(std::back_inserter(text), "\n## Of a {}\n", agent);
    }

    const std::string_view message = fact(entry, "message");
    fmt::format_to(std::back_inserter(text), "\n### {}\n\n", entry.name);
    if (!entry.text.empty()) fmt::format_to(std::back_inserter(text), "{}\n\n", entry.text);
    fmt::format_to(std::back_inserter(text), "- message: `{}`\n", message);
    for (const auto& [label, value] : entry.facts) {
      if (label != "message") fmt::format_to(std::back_inserter(text), "- {}: {}\n", label, value);
    }

    const std::string fields = fields_of(message);
    if (!fields.empty()) text += "\n" + fields;
  }
  return text;
}

std::string parameters_page() {
  std::string text = fmt::format("# Parameters of a match\n\n{}\n", kGenerated);
  text +=
      "What a Playmaker receives before the first decision. `cls match --set server::NAME=VALUE` "
      "changes a\n"
      "parameter.\n";

  for (const char* name : {"ServerParam", "PlayerParam", "PlayerType"}) {
    const ReferenceEntry* message = find(ReferenceKind::kMessage, name);
    fmt::format_to(std::back_inserter(text), "\n## {}\n\n{}\n\n{}", name,
                   message == nullptr ? "" : message->text, fields_of(name));
  }
  return text;
}

std::string ends_page() {
  std::string text =
      fmt::format("# Play modes and end reasons\n\n{}\n## Play modes\n\n", kGenerated);
  text +=
      "`WorldModel.game_mode_type`. A mode whose name ends in `_` has a side: "
      "`game_mode_side`.\n\n";

  base::Table modes;
  modes.add_columns({"mode", "number", "meaning"});
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind != ReferenceKind::kPlayMode) continue;
    modes.add_row({code(entry.name), std::string(fact(entry, "number")), entry.text});
  }

  text += modes.format_markdown(kStyle);
  text += "\n## End reasons\n\n`end_reason` of a result.\n";
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind != ReferenceKind::kEndReason) continue;
    // The text is from a page of the folder above.
    static const std::regex in_page(R"(\]\(#)");
    static const std::regex beside_page(R"(\]\((?=[a-z-]+\.md))");
    std::string about = std::regex_replace(entry.text, in_page, "](troubleshooting.md#");
    about = std::regex_replace(about, beside_page, "](../");

    fmt::format_to(std::back_inserter(text), "\n### {}\n\n{}\n", entry.name, about);
  }

  return text;
}

// The spellings are those of the code that each language's compiler of protobuf generates.
constexpr std::string_view kNamesInLanguages = R"(
## Names in your language

These pages have the names of the interface. `cls explain` also takes those of a language: `cls explain BodySmartKick`, `Self.IsKickable`,
`GameModeType.KickIn`.

| language | a field: `is_kickable` of `self` | a value: `KickIn_` | an action: `body_smart_kick` |
|---|---|---|---|
| Python | `world.self.is_kickable` | `pb.KickIn_` | `pb.PlayerAction(body_smart_kick=pb.Body_SmartKick(max_steps=2))` |
| JavaScript, TypeScript | `world.self.is_kickable` | `'KickIn_'` | `{ body_smart_kick: { max_steps: 2 } }` |
| Go | `world.GetSelf().GetIsKickable()` | `pb.GameModeType_KickIn_` | `&pb.PlayerAction{Action: &pb.PlayerAction_BodySmartKick{BodySmartKick: &pb.Body_SmartKick{MaxSteps: 2}}}` |
| Java | `world.getSelf().getIsKickable()` | `GameModeType.KickIn_` | `PlayerAction.newBuilder().setBodySmartKick(Body_SmartKick.newBuilder().setMaxSteps(2)).build()` |
| Rust | `world.self_.as_ref()?.is_kickable` | `GameModeType::KickIn` | `PlayerAction { action: Some(Action::BodySmartKick(BodySmartKick { max_steps: 2, ..Default::default() })) }` |
| C# | `world.Self.IsKickable` | `GameModeType.KickIn` | `new PlayerAction { BodySmartKick = new() { MaxSteps = 2 } }` |

A message that is not set is `null` in JavaScript, TypeScript and C# (`world.Ball?.Position`), `None` in Rust, and an empty message in Python, Go (by its
getters) and Java. In C# initializers fill lists: `new PlayerActions { Actions = { first, second } }`.
)";

std::string index_page() {
  return fmt::format(
      "# Reference\n\n{}\n"
      "| page | holds |\n|---|---|\n"
      "| [messages.md](messages.md) | every message and enumeration, with unit, range and when a "
      "field is set |\n"
      "| [actions.md](actions.md) | every action: what it does, ends in, and when it fails |\n"
      "| [parameters.md](parameters.md) | the parameters of a match, with units and defaults |\n"
      "| [modes.md](modes.md) | play modes and end reasons |\n\n"
      "`cls explain NAME` prints an entry of these pages in the terminal, `cls explain --list` "
      "their names.\n"
      "{}",
      kGenerated, kNamesInLanguages);
}

// The action with this message; null for another message.
const ReferenceEntry* action_of(std::string_view message) {
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind == ReferenceKind::kAction && fact(entry, "message") == message) return &entry;
  }
  return nullptr;
}

// The anchor that Markdown gives a heading.
std::string anchor(std::string_view heading) {
  std::string text(heading);
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::string page_of(const ReferenceEntry& entry) {
  if (entry.kind == ReferenceKind::kAction) return "actions.md#" + anchor(entry.name);
  if (entry.kind == ReferenceKind::kEndReason) return "modes.md#" + anchor(entry.name);

  const std::string_view block = entry.group.empty() ? entry.name : entry.group;
  if (block == kModeEnum) return "modes.md#play-modes";
  if (is_parameter_message(block)) return "parameters.md#" + anchor(block);
  if (const ReferenceEntry* action = action_of(block)) return page_of(*action);
  return "messages.md#" + anchor(block);
}

std::vector<std::pair<std::string, std::string>> reference_pages() {
  return {{"README.md", index_page()},
          {"messages.md", messages_page()},
          {"actions.md", actions_page()},
          {"parameters.md", parameters_page()},
          {"modes.md", ends_page()}};
}

}  // namespace cls::cli
