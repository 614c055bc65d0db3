// Replaces placeholders and writes files.
#include "tournament/tuning/candidate.h"

#include <fmt/format.h>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/replace_all.h"
#include "process/command_plan.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Json;

Json json_value(const Parameter& parameter, double value) {
  return Json::parse(value_text(parameter, value));
}

// "a.b" becomes member b of a.
Json json_of_values(const TuneConfig& config, const Values& values) {
  Json document = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) {
    Json* place = &document;
    std::string_view name = config.parameters[i].name;
    for (std::size_t dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.')) {
      place = &(*place)[std::string(name.substr(0, dot))];
      name.remove_prefix(dot + 1);
    }
    (*place)[std::string(name)] = json_value(config.parameters[i], values[i]);
  }
  return document;
}

}  // namespace

std::string with_values(std::string_view text, const TuneConfig& config, const Values& values) {
  std::string replaced(text);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Parameter& parameter = config.parameters[i];
    base::replace_all(replaced, "{" + parameter.name + "}", value_text(parameter, values[i]));
  }
  return replaced;
}

std::string side_of(const TuneConfig& config, const Values& values, const fs::path& file) {
  std::string side = with_values(config.team, config, values);
  base::replace_all(side, "{file}", file.string());
  if (config.environment.empty()) return side;
  std::string exports;
  for (const auto& [name, text] : config.environment) {
    exports += fmt::format("export {}={}; ", name,
                           process::shell_quoted(with_values(text, config, values)));
  }
  constexpr std::string_view kRun = "run:";
  return fmt::format("{}{}{}", kRun, exports, side.substr(kRun.size()));
}

std::string values_text(const TuneConfig& config, const Values& values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += fmt::format("{} = {}\n", config.parameters[i].name,
                        value_text(config.parameters[i], values[i]));
  }
  return text;
}

std::string file_text(const TuneConfig& config, const Values& values) {
  if (!config.file_template.empty()) return with_values(config.file_template, config, values);
  if (config.file.ends_with(".toml")) return values_text(config, values);
  return base::json_document(json_of_values(config, values));
}

base::Result<std::string> prepare_candidate(const TuneConfig& config, const Values& values,
                                            const fs::path& folder) {
  if (config.file.empty()) return side_of(config, values, {});
  TRY(base::create_folders(folder));
  const fs::path file = folder / config.file;
  TRY(base::write_file(file, file_text(config, values)));
  return side_of(config, values, file);
}

}  // namespace cls::tournament
