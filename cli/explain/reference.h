// The entries of `cls explain`: messages, fields, actions, play modes, end reasons, parameters.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cls::cli {

/// A file of docs/, proto/ or cli/explain/, embedded at build time.
struct ReferenceFile {
  std::string_view name;  ///< from the root of the source tree: "docs/actions.md"
  std::string_view text;
};
const std::vector<ReferenceFile>& reference_files();

enum class ReferenceKind { kMessage, kField, kAction, kEnum, kValue, kPlayMode, kEndReason };

/// "message", "field", "action", "enumeration", "value", "play mode", "end reason".
std::string_view name(ReferenceKind kind);

struct ReferenceEntry {
  ReferenceKind kind = ReferenceKind::kMessage;
  std::string name;   ///< "Self", "Self.stamina", "body_smart_kick", "KickOff_", "crashed"
  std::string group;  ///< message of a field, enumeration of a value, agent of an action
  std::string text;   ///< what it means; may be empty
  /// Label and value, in the order of output: {"type", "float"}, {"unit", "m"}.
  std::vector<std::pair<std::string, std::string>> facts;
};

/// All entries: those of a message directly before those of its fields.
const std::vector<ReferenceEntry>& reference();

/// The value of a fact; empty if the entry lacks it.
std::string_view fact(const ReferenceEntry& entry, std::string_view label);

/// The effect of an action, or the meaning of another entry; may be empty.
std::string_view meaning(const ReferenceEntry& entry);

/// The entries that `word` names: a full name, the last part of it ("stamina"), a name as a
/// language has it ("GameModeType.KickIn"), or a function in the projects of `cls new` ("go_to").
/// Case, `_` and `-` do not count. Exact names win; where there are none, a plural means its
/// singular ("tackles"), some words of users mean a name ("keeper"), and a part of its name means
/// an action ("smart_kick").
std::vector<const ReferenceEntry*> find_entries(std::string_view word);

/// The entries whose name, text or facts have `text`, whatever its case.
std::vector<const ReferenceEntry*> entries_with(std::string_view text);

/// Where an entry stands in docs/reference/: "messages.md#self", "actions.md#body_smart_kick".
std::string page_of(const ReferenceEntry& entry);

/// The pages of docs/reference/: name of the file and text.
std::vector<std::pair<std::string, std::string>> reference_pages();

}  // namespace cls::cli
