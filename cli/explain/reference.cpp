// Builds the reference from the interface, the manual and the notes.
#include "cli/explain/reference.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <span>
#include <sstream>

#include "base/text/enum_names.h"
#include "base/text/find_ignoring_case.h"
#include "base/text/trimmed.h"
#include "cli/explain/parameter_facts.h"
#include "cli/explain/proto_text.h"
#include "soccer/end_reason.h"

namespace cls::cli {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;
constexpr std::string_view kPlayModes = "GameModeType";

std::string_view file(std::string_view name) {
  for (const ReferenceFile& one : reference_files()) {
    if (one.name == name) return one.text;
  }
  return {};
}

void add_fact(Facts& facts, std::string_view label, std::string_view value) {
  if (!value.empty()) facts.emplace_back(label, value);
}

bool matches(std::string_view pattern, const std::string& name) {
  return fnmatch(std::string(pattern).c_str(), name.c_str(), 0) == 0;
}

// What comments of the protos leave out: unit, range, ... of fields, and meanings.
class Notes {
 public:
  std::map<std::string, std::string> of_field(const std::string& name,
                                              const std::string& type) const {
    std::map<std::string, std::string> values;
    for (const toml::node& node : *notes_["field"].as_array()) {
      const toml::table& rule = *node.as_table();
      if (!applies(rule, name, type)) continue;
      for (const char* key : {"unit", "range", "unknown", "set"}) {
        if (const auto value = rule[key].value<std::string>()) values[key] = *value;
      }
    }

    for (const toml::node& node : *meanings_["fields"].as_array()) {
      const toml::array& row = *node.as_array();
      const bool is_type = row.size() < 3 || row[2].value_or(std::string()) == type;
      if (is_type && matches(row[0].value_or(std::string_view()), name)) {
        values["meaning"] = row[1].value_or(std::string());
      }
    }

    return values;
  }

  std::string message(const std::string& name) const {
    return meanings_["messages"][name].value_or(std::string());
  }
  std::string value(const std::string& type, const std::string& name) const {
    return meanings_["values"][type][name].value_or(std::string());
  }
  std::string play_mode(const std::string& name) const {
    return meanings_["play_modes"][name].value_or(std::string());
  }

 private:
  static bool applies(const toml::table& rule, const std::string& name, const std::string& type) {
    const toml::array* types = rule["types"].as_array();
    const auto is_type = [&](const toml::node& one) { return one.value_or(std::string()) == type; };
    if (types != nullptr && std::none_of(types->begin(), types->end(), is_type)) return false;

    const toml::array& patterns = *rule["match"].as_array();
    return std::ranges::any_of(patterns, [&](const toml::node& pattern) {
      return matches(pattern.value_or(std::string_view()), name);
    });
  }

  const toml::table notes_ = toml::parse(file("cli/explain/notes.toml"));
  const toml::table meanings_ = toml::parse(file("cli/explain/meanings.toml"));
};

ReferenceEntry field_entry(const ProtoBlock& message, const ProtoField& field, const Notes& notes) {
  ReferenceEntry entry;
  entry.kind = ReferenceKind::kField;
  entry.name = message.name + "." + field.name;
  entry.group = message.name;
  entry.text = field.comment;
  entry.facts = {{"type", field.type}};

  auto values = notes.of_field(entry.name, field.type);
  if (is_parameter_message(message.name)) {
    const ParameterFacts facts = parameter_facts(message.name, field.name);
    if (!facts.unit.empty()) values["unit"] = facts.unit;
    if (!facts.effect.empty()) values["meaning"] = facts.effect;
    values["default"] = facts.default_value;
    values["setting"] = facts.setting;
    values["range"].clear();  // a setting may have any value
  }

  if (entry.text.empty()) entry.text = values["meaning"];
  for (const char* key : {"unit", "range", "default", "unknown", "set", "setting"}) {
    add_fact(entry.facts, key, values[key]);
  }

  return entry;
}

void add_block(std::vector<ReferenceEntry>& all, const ProtoBlock& block, const Notes& notes) {
  all.push_back({block.is_enum ? ReferenceKind::kEnum : ReferenceKind::kMessage,
                 block.name,
                 "",
                 block.comment.empty() ? notes.message(block.name) : block.comment,
                 {}});
  for (const ProtoField& field : block.fields) {
    if (!block.is_enum) {
      all.push_back(field_entry(block, field, notes));
      continue;
    }

    const bool is_mode = block.name == kPlayModes;

    ReferenceEntry entry;
    entry.kind = is_mode ? ReferenceKind::kPlayMode : ReferenceKind::kValue;
    entry.name = field.name;
    entry.group = block.name;
    entry.text = is_mode                 ? notes.play_mode(field.name)
                 : field.comment.empty() ? notes.value(block.name, field.name)
                                         : field.comment;
    entry.facts = {{"number", std::to_string(field.number)}};
    all.push_back(std::move(entry));
  }
}

// The cells of "| a | b |"; empty for another line.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  if (line.size() < 2 || line.front() != '|') return cells;

  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    cells.emplace_back(base::trimmed(cell, " "));
  }

  return cells;
}

// A row of the tables of docs/actions.md.
struct ActionRow {
  std::vector<std::string> patterns;  ///< names; "neck_*"
  std::string kind;                   ///< "main" or "side"; empty for coach and trainer
  std::string effect;
  std::string ends;
  std::string fails;
};

std::vector<ActionRow> action_rows() {
  static const std::regex name_in_code("`([a-z_*]+)`");
  std::vector<ActionRow> rows;
  std::istringstream lines{std::string(file("docs/actions.md"))};

  std::size_t columns = 0;  // of the table of actions around the line; 0: none
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (!cells.empty() && cells[0] == "action") columns = cells.size();
    if (cells.empty()) columns = 0;
    if (columns == 0 || cells.size() != columns || cells[0].front() != '`') continue;

    ActionRow row;
    for (std::sregex_iterator i(cells[0].begin(), cells[0].end(), name_in_code), end; i != end;
         ++i) {
      row.patterns.push_back((*i)[1]);
    }

    const bool is_player = columns == 5;
    row.kind = is_player ? cells[1] : "";
    row.effect = cells[is_player ? 2 : 1];
    row.ends = is_player ? cells[3] : "";
    row.fails = cells.back();
    rows.push_back(std::move(row));
  }

  return rows;
}

const ActionRow* find_row(const std::vector<ActionRow>& rows, const std::string& action) {
  for (const ActionRow& row : rows) {
    for (const std::string& pattern : row.patterns) {
      if (matches(pattern, action)) return &row;
    }
  }
  return nullptr;
}

// The fields of PlayerAction, CoachAction and TrainerAction.
void add_actions(std::vector<ReferenceEntry>& all, const std::vector<ProtoBlock>& blocks) {
  const std::vector<ActionRow> rows = action_rows();
  std::map<std::string, std::string> comments;
  for (const ProtoBlock& block : blocks) comments[block.name] = block.comment;

  for (const auto& [message, agent] :
       {std::pair{"PlayerAction", "player"}, std::pair{"CoachAction", "coach"},
        std::pair{"TrainerAction", "trainer"}}) {
    const auto block = std::ranges::find(blocks, message, &ProtoBlock::name);
    if (block == blocks.end()) continue;
    for (const ProtoField& field : block->fields) {
      ReferenceEntry entry;

      entry.kind = ReferenceKind::kAction;
      entry.name = field.name;
      entry.group = agent;
      entry.text = comments[field.type];
      add_fact(entry.facts, "message", field.type);

      if (const ActionRow* row = find_row(rows, field.name)) {
        add_fact(entry.facts, "class", row->kind);
        add_fact(entry.facts, "does", row->effect);
        add_fact(entry.facts, "ends in", row->ends);
        add_fact(entry.facts, "fails when", row->fails);
        // Its message, and the choice in the message of all actions, mean the same.
        const std::string choice = block->name + "." + field.name;
        for (ReferenceEntry& one : all) {
          const bool same = one.name == field.type || one.name == choice;
          if (same && one.text.empty()) one.text = row->effect;
        }
      }

      all.push_back(std::move(entry));
    }
  }
}

// "### crashed" and the text below it, in docs/troubleshooting.md.
void add_end_reasons(std::vector<ReferenceEntry>& all) {
  std::istringstream lines{std::string(file("docs/troubleshooting.md"))};
  ReferenceEntry* current = nullptr;

  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      current = nullptr;

      const std::string heading = line.substr(line.find_first_not_of("# "));
      if (line.starts_with("### ") && soccer::parse_end_reason(heading)) {
        current = &all.emplace_back();
        current->kind = ReferenceKind::kEndReason;
        current->name = heading;
      }
    } else if (current != nullptr && (!line.empty() || !current->text.empty())) {
      const bool goes_on = !current->text.empty() && current->text.back() != '\n' &&
                           !line.empty() && !line.starts_with("- ");
      if (goes_on) {
        current->text += ' ';
      } else if (!current->text.empty()) {
        current->text += '\n';
      }
      current->text += line;
    }
  }

  for (ReferenceEntry& entry : all) {
    while (!entry.text.empty() && entry.text.back() == '\n') entry.text.pop_back();
  }
}

std::vector<ReferenceEntry> build() {
  const Notes notes;
  const std::vector<ProtoBlock> blocks = read_proto(file("proto/playmaker.proto"));

  std::vector<ReferenceEntry> all;
  for (const ProtoBlock& block : blocks) add_block(all, block, notes);
  for (const ProtoBlock& block : read_proto(file("proto/team_playmaker.proto"))) {
    add_block(all, block, notes);
  }

  add_actions(all, blocks);
  add_end_reasons(all);

  return all;
}

// Lower case without '_' and '-': "kick_off" and "KickOff_" are the same.
std::string folded(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c != '_' && c != '-' && c != ' ') {
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return result;
}

// Fields of PlayerAction and the like: the action says more.
bool is_choice(const ReferenceEntry& entry) {
  return entry.group == "PlayerAction" || entry.group == "CoachAction" ||
         entry.group == "TrainerAction";
}

std::string_view last_part(std::string_view name) { return name.substr(name.rfind('.') + 1); }

}  // namespace

std::string_view name(ReferenceKind kind) {
  constexpr auto kNames = base::enum_names<ReferenceKind>(
      "message", "field", "action", "enumeration", "value", "play mode", "end reason");
  return kNames.name(kind);
}

const std::vector<ReferenceEntry>& reference() {
  static const std::vector<ReferenceEntry> entries = build();
  return entries;
}

std::string_view fact(const ReferenceEntry& entry, std::string_view label) {
  for (const auto& [name, value] : entry.facts) {
    if (name == label) return value;
  }
  return {};
}

std::string_view meaning(const ReferenceEntry& entry) {
  const std::string_view effect = fact(entry, "does");
  return effect.empty() ? std::string_view(entry.text) : effect;
}

namespace {

using Words = std::pair<std::string_view, std::string_view>;

// Words of users for names of the interface.
constexpr Words kSynonyms[] = {
    {"goalie", "helios_goalie"},    {"keeper", "helios_goalie"},  {"speed", "velocity"},
    {"energy", "stamina"},          {"number", "uniform_number"}, {"unum", "uniform_number"},
    {"run", "body_go_to_point"},    {"shot", "helios_shoot"},     {"draw", "debug_client"},
    {"look", "neck_turn_to_point"},
};

// Functions in the projects of `cls new`, and what they return.
constexpr Words kProjectFunctions[] = {
    {"before_kick_off", "bhv_before_kick_off"},
    {"go_to", "body_go_to_point"},
    {"watch_ball", "neck_turn_to_ball_or_scan"},
    {"watch_goalie", "neck_turn_to_goalie_or_scan"},
    {"shoot", "helios_shoot"},
    {"basic_move", "helios_basic_move"},
    {"set_play", "helios_set_play"},
    {"penalty", "helios_penalty"},
    {"substitute", "do_helios_substitute"},
    {"say_player_types", "do_helios_say_player_types"},
    {"show_text", "Log"},
    {"show_line", "Log"},
    {"plan_attack", "helios_offensive_planner"},
};

// What a list of words has for one; empty: nothing.
std::string name_in(std::span<const Words> list, std::string_view word) {
  const auto found = std::ranges::find_if(
      list, [&word](const Words& one) { return folded(word) == folded(one.first); });
  return found == list.end() ? "" : std::string(found->second);
}

// The singular of a plural, the name that a synonym means; empty for other words.
std::string other_form(std::string_view word) {
  const std::string name = name_in(kSynonyms, word);
  if (!name.empty()) return name;
  return word.size() > 3 && word.ends_with('s') ? std::string(word.substr(0, word.size() - 1)) : "";
}

// An action or a value as languages write it with what it belongs to: "GameModeType.KickIn" in C#,
// "GameModeType_KickIn_" in Go, "PlayerAction.BodySmartKick". Folded, without separators.
std::string qualified(const ReferenceEntry& entry) {
  const bool is_action = entry.kind == ReferenceKind::kAction;
  const bool is_value =
      entry.kind == ReferenceKind::kValue || entry.kind == ReferenceKind::kPlayMode;
  if (!is_action && !is_value) return {};
  return folded(entry.group + (is_action ? "Action" : "") + entry.name);
}

std::string without_separators(std::string_view word) {
  std::string result = folded(word);
  std::erase_if(result, [](char c) { return c == '.' || c == ':'; });
  return result;
}

std::vector<const ReferenceEntry*> entries_named(std::string_view word) {
  const auto select = [](auto matches) {
    std::vector<const ReferenceEntry*> found;
    for (const ReferenceEntry& entry : reference()) {
      if (!is_choice(entry) && matches(entry)) found.push_back(&entry);
    }
    return found;
  };

  auto found = select([&](const ReferenceEntry& entry) { return entry.name == word; });

  const std::string wanted = folded(word);
  if (found.empty()) {
    found = select([&](const ReferenceEntry& entry) { return folded(entry.name) == wanted; });
  }
  if (found.empty()) {
    found = select(
        [&](const ReferenceEntry& entry) { return folded(last_part(entry.name)) == wanted; });
  }
  if (const std::string plain = without_separators(word); found.empty() && !plain.empty()) {
    found = select([&](const ReferenceEntry& entry) { return qualified(entry) == plain; });
  }

  return found;
}

// The actions whose name has the word between separators: "smart_kick" of body_smart_kick.
std::vector<const ReferenceEntry*> entries_with_part(std::string_view word) {
  const auto parts = [](std::string_view text) {
    std::string result = "_";
    for (const char c : text) {
      const bool separates = c == '-' || c == ' ';
      result += separates ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result + "_";
  };

  std::vector<const ReferenceEntry*> found;
  for (const ReferenceEntry& entry : reference()) {
    if (entry.kind != ReferenceKind::kAction || word.empty()) continue;
    if (parts(entry.name).find(parts(word)) != std::string::npos) found.push_back(&entry);
  }
  return found;
}

}  // namespace

std::vector<const ReferenceEntry*> find_entries(std::string_view word) {
  auto found = entries_named(name_in(kProjectFunctions, word));
  for (const ReferenceEntry* entry : entries_named(word)) {
    if (std::ranges::count(found, entry) == 0) found.push_back(entry);
  }
  if (!found.empty()) return found;

  std::string other = other_form(word);
  found = entries_named(other);
  if (found.empty()) found = entries_named(other_form(other));  // "shots"
  if (found.empty()) found = entries_with_part(word);
  return found;
}

std::vector<const ReferenceEntry*> entries_with(std::string_view text) {
  const auto has = [text](std::string_view where) {
    return base::find_ignoring_case(where, text) != std::string_view::npos;
  };

  std::vector<const ReferenceEntry*> found;
  for (const ReferenceEntry& entry : reference()) {
    const bool in_facts =
        std::ranges::any_of(entry.facts, [&](const auto& one) { return has(one.second); });
    if (!is_choice(entry) && (has(entry.name) || has(entry.text) || in_facts)) {
      found.push_back(&entry);
    }
  }

  return found;
}

}  // namespace cls::cli
