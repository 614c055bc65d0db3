// Parses cls.toml with toml++ and writes it in canonical form.
#include "tournament/config/config_file.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "base/io/whole_file.h"
#include "base/text/stored_formats.h"
#include "match/terms/endpoint.h"
#include "match/terms/match_settings.h"
#include "match/terms/mixed_side.h"
#include "match/terms/toml_schema.h"
#include "process/command_plan.h"
#include "tournament/config/config_keys.h"
#include "tournament/config/stage_keys.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;

// The elements of an array that has this type only.
template <class Element>
std::optional<std::vector<Element>> elements_of(const toml::array& array) {
  std::vector<Element> elements;
  for (const toml::node& node : array) {
    const auto* element = node.as<Element>();
    if (element == nullptr) return std::nullopt;
    elements.push_back(element->get());
  }
  return elements;
}

std::optional<ConfigValue> parse_value(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return ConfigValue(flag->get());
  if (const auto* whole = node.as_integer()) return ConfigValue(whole->get());
  if (const auto* real = node.as_floating_point()) return ConfigValue(real->get());
  if (const auto* text = node.as_string()) return ConfigValue(text->get());
  const toml::array* array = node.as_array();
  if (array == nullptr) return std::nullopt;
  if (auto strings = elements_of<std::string>(*array)) return ConfigValue(*std::move(strings));
  if (auto numbers = elements_of<std::int64_t>(*array)) return ConfigValue(*std::move(numbers));

  std::vector<Texts> lists;
  for (const toml::node& inner : *array) {
    const toml::array* list = inner.as_array();
    auto strings = list == nullptr ? std::nullopt : elements_of<std::string>(*list);
    if (!strings) return std::nullopt;
    lists.push_back(*std::move(strings));
  }
  return ConfigValue(std::move(lists));
}

// A parameter of the soccer server as text: 10, 0.5, true, name.
std::optional<std::string> format_parameter(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* whole = node.as_integer()) return fmt::to_string(whole->get());
  if (const auto* real = node.as_floating_point()) return fmt::format("{}", real->get());
  if (const auto* text = node.as_string()) return text->get();
  return std::nullopt;
}

struct Entry {
  std::string key;
  const toml::node* node;
};

// toml++ sorts by name; the order of the file decides the seeding.
std::vector<Entry> in_file_order(const toml::table& table) {
  std::vector<Entry> entries;
  for (const auto& [key, node] : table) entries.push_back({std::string(key.str()), &node});
  const auto position = [](const Entry& entry) {
    const toml::source_position begin = entry.node->source().begin;
    return std::pair(begin.line, begin.column);
  };
  std::ranges::stable_sort(entries, {}, position);
  return entries;
}

// toml++ recurses into the parts of a dotted key.
constexpr std::ptrdiff_t kMaxKeyParts = 1000;

// The line of a key with too many parts, if there is one.
std::optional<toml::source_index> find_deep_key(std::string_view text) {
  for (toml::source_index line = 1; !text.empty(); ++line) {
    const std::string_view whole = text.substr(0, text.find('\n'));
    const std::string_view key = whole.substr(0, whole.find_first_of("=#"));
    if (std::ranges::count(key, '.') >= kMaxKeyParts) return line;
    text.remove_prefix(std::min(whole.size() + 1, text.size()));
  }
  return std::nullopt;
}

class Parser {
 public:
  explicit Parser(std::string file) : file_(std::move(file)) {}

  ParsedConfig parse(std::string_view text) {
    if (const auto line = find_deep_key(text)) {
      add_error(*line, fmt::format("a key of more than {} parts", kMaxKeyParts));
      return std::move(parsed_);
    }
    try {
      const toml::table table = toml::parse(text, file_);
      parse_top(table);
    } catch (const toml::parse_error& error) {
      add_error(error.source().begin.line, std::string(error.description()));
    }
    return std::move(parsed_);
  }

 private:
  void add_error(toml::source_index line, const std::string& what) {
    parsed_.errors.push_back(fmt::format("{}:{}: {}", file_, line, what));
  }
  void add_error(const Entry& entry, const std::string& what) {
    add_error(entry.node->source().begin.line, what);
  }

  void note_line(const Entry& entry, const std::string& key) {
    parsed_.lines[key] = static_cast<int>(entry.node->source().begin.line);
  }

  // `parent` is the table that the entry belongs to, with a dot at its end; empty: the file.
  const toml::table* table_of(const Entry& entry, std::string_view parent = "",
                              std::string_view hint = "") {
    const toml::table* table = entry.node->as_table();
    if (table == nullptr) {
      add_error(entry, fmt::format("'{0}' must be a table, [{1}{0}]{2}", entry.key, parent, hint));
    }
    return table;
  }

  // A file without a schema is of the first version. Keys of a newer version are not known.
  bool check_schema(const toml::table& top) {
    const toml::node* node = top.get("schema");
    if (node == nullptr) return true;
    const auto error = match::schema_error(*node, base::kConfigSchema);
    if (error) add_error(node->source().begin.line, *error);
    return !error;
  }

  void parse_top(const toml::table& top) {
    if (!check_schema(top)) return;
    for (const Entry& entry : in_file_order(top)) {
      if (entry.key == "schema") continue;
      if (entry.key == "stages") {
        parse_stages(entry);
        continue;
      }

      const auto part = std::ranges::find(kParts, entry.key, &Part::name);
      if (part == std::end(kParts)) {
        add_error(entry, unknown_key(entry.node->is_table() ? "table" : "key", entry.key,
                                     {"tournament", "server", "player", "teams", "stages"}));
      } else if (const toml::table* table = table_of(entry)) {
        (this->*part->parse)(entry.key, *table);
      }
    }
  }

  void parse_tournament(const std::string& /*name*/, const toml::table& table) {
    for (const Entry& entry : in_file_order(table)) {
      if (parse_key(entry, tournament_keys(), parsed_.config)) note_line(entry, entry.key);
    }
  }

  void parse_stages(const Entry& entry) {
    const toml::array* array = entry.node->as_array();
    if (array == nullptr || !array->is_homogeneous(toml::node_type::table)) {
      add_error(entry, "'stages' must be a list of tables, [[stages]] for each");
      return;
    }
    for (const toml::node& node : *array) {
      Stage& stage = parsed_.config.competition.stages.emplace_back();
      for (const Entry& field : in_file_order(*node.as_table())) {
        parse_key(field, stage_keys(), stage);
      }
    }
  }

  // False if there is no such key.
  template <class Key, class Target>
  bool parse_key(const Entry& entry, const std::vector<Key>& keys, Target& target) {
    const auto key = std::ranges::find(keys, entry.key, &Key::name);
    if (key == keys.end()) {
      std::vector<std::string_view> known;
      std::ranges::transform(keys, std::back_inserter(known), &Key::name);
      add_error(entry, unknown_key("key", entry.key, known));
      return false;
    }

    const auto value = parse_value(*entry.node);
    const auto read = value ? key->parse(target, *value)
                            : base::Result<void>(base::Error{"unsupported value type"});
    if (!read) add_error(entry, fmt::format("{}: {}", entry.key, read.error().message));
    return true;
  }

  void parse_settings(const std::string& module, const toml::table& table) {
    for (const Entry& entry : in_file_order(table)) {
      const auto value = format_parameter(*entry.node);
      if (!value) {
        add_error(entry, fmt::format("{}: must be a number, true, false or a string", entry.key));
        continue;
      }
      ServerSetting setting{module + "::" + entry.key, *value};
      note_line(entry, setting.name);
      match::MatchOptions scratch;
      const auto applied = match::apply_match_setting(scratch, setting.name + "=" + setting.value);
      if (!applied) add_error(entry, applied.error().message);
      parsed_.config.conditions.settings.push_back(std::move(setting));
    }
  }

  void parse_teams(const std::string& /*name*/, const toml::table& table) {
    for (const Entry& entry : in_file_order(table)) {
      const toml::table* team = table_of(entry, "teams.", " with an endpoint");
      if (team == nullptr) continue;

      if (const auto good = match::check_team_name(entry.key); !good) {
        add_error(entry, good.error().message);
      }

      const std::string endpoint = parse_team(*team);
      if (endpoint.empty()) add_error(entry, fmt::format("team '{}' has no endpoint", entry.key));
      parsed_.config.competition.teams.push_back({entry.key, endpoint});
    }
  }

  // The endpoint; "?" if it is not a string.
  std::string parse_team(const toml::table& team) {
    std::string endpoint;
    for (const Entry& field : in_file_order(team)) {
      if (field.key != "endpoint") {
        add_error(field, unknown_key("key", field.key, {"endpoint"}));
      } else if (const auto* text = field.node->as_string()) {
        endpoint = text->get();
        const auto parsed = match::parse_endpoint(endpoint);
        if (!parsed) add_error(field, parsed.error().message);
      } else {
        add_error(field, "endpoint: must be a string");
        endpoint = "?";
      }
    }
    return endpoint;
  }

  struct Part {
    std::string_view name;
    void (Parser::*parse)(const std::string& name, const toml::table& table);
  };
  static const std::array<Part, 4> kParts;

  std::string file_;
  ParsedConfig parsed_;
};

const std::array<Parser::Part, 4> Parser::kParts = {{{"tournament", &Parser::parse_tournament},
                                                     {"server", &Parser::parse_settings},
                                                     {"player", &Parser::parse_settings},
                                                     {"teams", &Parser::parse_teams}}};

struct Line {
  std::string section;
  std::string key;
  std::string value;
  int element = 0;  // of an array of tables, from 1; 0: the section is a table
};

std::vector<Line> lines_of(const TournamentConfig& config, bool plan_only) {
  std::vector<Line> lines;
  for (const ConfigKey& key : tournament_keys()) {
    const bool planned = key.group != KeyGroup::kExecution && key.group != KeyGroup::kReport;
    if (plan_only && !planned) continue;
    if (std::string value = key.format(config); !value.empty()) {
      lines.push_back({"tournament", std::string(key.name), std::move(value), 0});
    }
  }

  int element = 0;
  for (const Stage& stage : config.competition.stages) {
    ++element;
    for (const StageKey& key : stage_keys()) {
      if (std::string value = key.format(stage); !value.empty()) {
        lines.push_back({"stages", std::string(key.name), std::move(value), element});
      }
    }
  }

  for (const char* module : {"server", "player"}) {
    const std::string prefix = std::string(module) + "::";
    for (const ServerSetting& setting : config.conditions.settings) {
      if (!setting.name.starts_with(prefix)) continue;
      lines.push_back({module, setting.name.substr(prefix.size()), toml_quoted(setting.value), 0});
    }
  }

  for (const TeamEntry& team : config.competition.teams) {
    // Quoted, because a name may contain '+'.
    lines.push_back({"teams." + toml_quoted(team.name), "endpoint", toml_quoted(team.endpoint), 0});
  }
  return lines;
}

std::string label(const Line& line) {
  if (line.section == "tournament") return line.key;
  if (line.element > 0) return fmt::format("stage {}: {}", line.element, line.key);
  return fmt::format("[{}] {}", line.section, line.key);
}

}  // namespace

ParsedConfig parse_config(std::string_view text, const std::string& file) {
  return Parser(file).parse(text);
}

ParsedConfig read_config(const fs::path& file) {
  const auto text = base::read_text(file);
  if (!text) return {{}, {fmt::format("cannot read {}", file.string())}, {}};
  ParsedConfig parsed = parse_config(*text, file.string());
  fs::path& folder = parsed.config.execution.folder;
  folder = (fs::absolute(file).parent_path() / folder).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // a trailing slash
  return parsed;
}

std::optional<fs::path> find_config(const fs::path& from) {
  std::error_code code;
  fs::path folder = fs::absolute(from, code);
  while (!code) {
    if (fs::is_regular_file(folder / kConfigFile, code)) return folder / kConfigFile;
    if (folder == folder.parent_path()) break;
    folder = folder.parent_path();
    code.clear();
  }
  return std::nullopt;
}

std::string endpoint_from(const fs::path& folder, const std::string& endpoint) {
  std::error_code code;
  if (fs::equivalent(folder, fs::current_path(code), code)) return endpoint;

  const std::size_t colon = endpoint.find(':');
  const std::string kind = endpoint.substr(0, colon + 1);
  const std::string rest = colon == std::string::npos ? "" : endpoint.substr(colon + 1);
  const auto from_folder = [&folder](const std::string& path) {
    return (folder / path).lexically_normal().string();
  };

  if (kind == "mix:") {
    const auto parts = match::parse_mixed_side(rest);
    if (!parts) return endpoint;
    std::string text;
    for (const match::MixedPart& part : *parts) {
      text += fmt::format("{}{}={}", text.empty() ? "mix:" : ";", part.label,
                          endpoint_from(folder, part.side));
    }
    return text;
  }
  if (const std::size_t equals = rest.find('='); kind == "planner:" && equals != rest.npos) {
    return kind + from_folder(rest.substr(0, equals)) + "=" +
           endpoint_from(folder, rest.substr(equals + 1));
  }
  if (kind == "each:") return kind + endpoint_from(folder, rest);
  if (kind == "run:") {
    return fmt::format("run:cd {} && {}", process::shell_quoted(folder.string()), rest);
  }
  const bool file =
      kind == "team:" || kind == "unix:" || (kind == "mock:" && rest.ends_with(".json"));
  return file ? kind + from_folder(rest) : endpoint;
}

std::string format_config(const TournamentConfig& config, bool plan_only) {
  std::string text;
  std::pair<std::string, int> header;
  for (const Line& line : lines_of(config, plan_only)) {
    if (std::pair now(line.section, line.element); now != header) {
      header = std::move(now);
      fmt::format_to(std::back_inserter(text),
                     fmt::runtime(line.element > 0 ? "{}[[{}]]\n" : "{}[{}]\n"),
                     text.empty() ? "" : "\n", line.section);
    }
    fmt::format_to(std::back_inserter(text), "{} = {}\n", line.key, line.value);
  }
  return text;
}

std::string first_difference(const TournamentConfig& now, const TournamentConfig& before) {
  const std::vector<Line> a = lines_of(now, true);
  const std::vector<Line> b = lines_of(before, true);

  const auto same_key = [](const Line& x, const Line& y) {
    return x.section == y.section && x.element == y.element && x.key == y.key;
  };
  const auto holds = [&](const std::vector<Line>& lines, const Line& line) {
    return std::ranges::any_of(lines, [&](const Line& other) { return same_key(other, line); });
  };

  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i < a.size() && i < b.size() && same_key(a[i], b[i])) {
      if (a[i].value != b[i].value) {
        return fmt::format("{} is {}, was {}", label(a[i]), a[i].value, b[i].value);
      }
      continue;
    }

    if (i < a.size() && !holds(b, a[i])) {
      return fmt::format("{} is {}, was not set", label(a[i]), a[i].value);
    }
    if (i < b.size() && !holds(a, b[i])) {
      return fmt::format("{} is not set, was {}", label(b[i]), b[i].value);
    }

    const Line& line = i < a.size() ? a[i] : b[i];
    return fmt::format("[{}] is at another position", line.section);
  }
  return {};
}

std::string commented_config() {
  std::string text =
      "# A cls tournament. `cls tournament plan DIR` lists its matches, `cls tournament run DIR`\n"
      "# plays them. Lines that start with # show defaults and examples.\n"
      "\n"
      "schema = 1  # version of the format of this file\n"
      "\n"
      "[tournament]\n";

  const TournamentConfig defaults;
  for (const ConfigKey& key : tournament_keys()) {
    const bool essential = key.name == "format" || key.name == "rounds" || key.name == "seed";
    const std::string value = key.format(defaults);
    fmt::format_to(std::back_inserter(text), "# {}\n{}{} = {}\n", key.help, essential ? "" : "#",
                   key.name, value.empty() ? key.example : value);
  }

  text +=
      "\n"
      "# Parameters of the soccer server, for every match.\n"
      "[server]\n"
      "#nr_normal_halfs = 2\n"
      "\n"
      "# The teams. An endpoint is mock, mock:hold, HOST:PORT, HOST:PORT+step, unix:PATH,\n"
      "# run:COMMAND or team:DIR. Names are sides of `cls match` too: cls match RED BLUE\n"
      "[teams.RED]\n"
      "endpoint = \"mock\"\n"
      "\n"
      "[teams.BLUE]\n"
      "endpoint = \"mock\"\n";
  return text;
}

}  // namespace cls::tournament
