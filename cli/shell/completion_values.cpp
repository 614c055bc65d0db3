// One row per placeholder.
#include "cli/shell/completion_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <variant>

#include "cli/project/project_files.h"
#include "cli/shell/help_topics.h"
#include "cli/shell/shells.h"
#include "mock-server/script/named_behaviors.h"
#include "scenario/scenario_library.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"
#include "tournament/config/config_file.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

using Source = void (*)(const ValueContext&, Completion&);

void add_paths(Completion& completion, PathKind kind, std::string_view prefix = "") {
  completion.paths = kind;
  completion.path_prefix = prefix;
}

void add_files(const ValueContext&, Completion& completion) {
  add_paths(completion, PathKind::kFiles);
}

void add_folders(const ValueContext&, Completion& completion) {
  add_paths(completion, PathKind::kFolders);
}

// Shells insert candidates as they are: a name that they would not read as one word, or would run,
// has no place among them.
bool is_plain_word(std::string_view text) {
  constexpr std::string_view kPlain = "_-.:+@%/=,";
  return !text.empty() && std::ranges::all_of(text, [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || kPlain.find(c) != kPlain.npos;
  });
}

// Adds the teams of the cls.toml in or above the working directory, which may be a stranger's.
void add_teams(Completion& completion) {
  std::error_code code;
  const auto file = tournament::find_config(fs::current_path(code));
  if (!file) return;
  for (const auto& team : tournament::read_config(*file).config.competition.teams) {
    if (is_plain_word(team.name)) completion.candidates.push_back({team.name, team.endpoint});
  }
}

void add_behaviors(Completion& completion, const std::string& prefix) {
  for (const std::string_view name : mock_server::behavior_names()) {
    completion.candidates.push_back({prefix + std::string(name), "a behavior of the mock"});
  }
}

void add_sides(const ValueContext& context, Completion& completion) {
  constexpr std::pair<const char*, PathKind> kPathForms[] = {{"mock:", PathKind::kFiles},
                                                             {"unix:", PathKind::kFiles},
                                                             {"planner:", PathKind::kFiles},
                                                             {"policy:", PathKind::kFiles},
                                                             {"team:", PathKind::kFolders}};

  for (const auto& [prefix, kind] : kPathForms) {
    if (context.word.starts_with(prefix)) add_paths(completion, kind, prefix);
  }

  if (context.word.starts_with("mock:")) {
    completion.candidates.push_back({"mock:learned", "the team that learned from the planner"});
    return add_behaviors(completion, "mock:");
  }
  if (completion.paths != PathKind::kNone) return;

  add_teams(completion);
  for (const auto& [form, note] : {std::pair{"mock", "the bundled Playmaker"},
                                   {"mock:", "a behavior or FILE.json"},
                                   {"localhost:", "a running Playmaker on PORT"},
                                   {"tls:", "HOST:PORT with TLS"},
                                   {"unix:", "PATH of a socket"},
                                   {"run:", "COMMAND that starts a Playmaker"},
                                   {"each:run:", "COMMAND, a process for each agent"},
                                   {"team:", "DIR of an external team"},
                                   {"policy:", "FILE of a trained policy"},
                                   {"planner:", "FILE=SIDE with other parameters"}}) {
    completion.candidates.push_back({form, note});
  }
}

void add_servers(const ValueContext&, Completion& completion) {
  completion.candidates = {{"embedded", "in the process"}, {"rcssserver", "on PATH"}};
  add_paths(completion, PathKind::kFiles);
}

void add_settings(const ValueContext& context, Completion& completion) {
  add_parameters(completion, context.word);
}

void add_scenarios(const ValueContext&, Completion& completion) {
  if (const auto scenarios = scenario::shipped_scenarios()) {
    for (const auto& scenario : *scenarios) {
      completion.candidates.push_back({scenario.name, scenario.about});
    }
  }

  add_paths(completion, PathKind::kFiles);
}

void add_mock_behaviors(const ValueContext&, Completion& completion) {
  add_behaviors(completion, "");
  add_paths(completion, PathKind::kFiles);
}

void add_names(Completion& completion, const std::vector<std::string_view>& names) {
  for (const std::string_view name : names)
    completion.candidates.push_back({std::string(name), ""});
}

void add_languages(const ValueContext&, Completion& completion) {
  add_names(completion, project_languages());
}

void add_templates(const ValueContext&, Completion& completion) {
  add_names(completion, project_templates());
}

void add_shells(const ValueContext&, Completion& completion) {
  add_names(completion, shell_names());
}

struct SourceRow {
  std::string_view name;  ///< of the option or argument, or its placeholder
  Source source;
};

constexpr SourceRow kSources[] = {
    {"--template", add_templates},
    {"BASE", add_sides},
    {"BEHAVIOR", add_mock_behaviors},
    {"DIR", add_folders},
    {"ENDPOINT", add_sides},
    {"FILE", add_files},
    {"IN", add_files},
    {"LANGUAGE", add_languages},
    {"LEFT", add_sides},
    {"LOG", add_files},
    {"NAME=VALUE", add_settings},
    {"NEW", add_sides},
    {"OUT", add_files},
    {"RIGHT", add_sides},
    {"SCENARIO", add_scenarios},
    {"SERVER", add_servers},
    {"SHELL", add_shells},
    {"SIDE", add_sides},
    {"WHAT", add_files},
};

Source source_of(std::string_view name) {
  const auto* row = std::ranges::find(kSources, name, &SourceRow::name);
  return row == std::end(kSources) ? nullptr : row->source;
}

template <typename Params>
void add_table(Completion& completion, std::string_view module, const std::string& word,
               const soccer::ParameterTable<Params>& table) {
  for (const auto& row : table) {
    const std::string name = fmt::format("{}::{}=", module, row.name);
    const bool is_switch = std::holds_alternative<bool Params::*>(row.member);

    if (!word.starts_with(name)) {
      completion.candidates.push_back({name, std::string(row.effect)});
    } else if (is_switch) {
      for (const char* value : {"on", "off"}) completion.candidates.push_back({name + value, ""});
    }
  }
}

}  // namespace

Completion values_of(const Option& option, const ValueContext& context) {
  Completion completion;
  for (const std::string& word : option.form.words) completion.candidates.push_back({word, ""});
  if (!completion.candidates.empty()) return completion;

  const bool argument = is_argument(option);
  Source source = source_of(name_of(option));
  if (source == nullptr && !argument) source = source_of(value_name(option));
  if (source != nullptr) source(context, completion);
  return completion;
}

void add_parameters(Completion& completion, const std::string& word) {
  add_table(completion, "server", word, soccer::server_param_table());
  add_table(completion, "player", word, soccer::player_param_table());
}

void add_topic_names(Completion& completion) {
  for (const HelpTopic& topic : help_topics()) {
    completion.candidates.push_back({topic.name, topic.title});
  }
}

}  // namespace cls::cli
