// The files that `cls new` writes: the examples as projects of their own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace cls::cli {

/// A file of examples/, proto/ or python/, embedded at build time.
struct EmbeddedFile {
  std::string_view name;  ///< from the root of the source tree: "examples/go/run"
  std::string_view text;
};
const std::vector<EmbeddedFile>& embedded_files();

/// The text of one of them; empty if there is none of that name.
std::string_view embedded_file(std::string_view name);

/// A file of a project.
struct ProjectFile {
  std::string path;  ///< in the folder of the project: "src/decide.ts"
  std::string text;
};

/// "python", "typescript", ...
const std::vector<std::string_view>& project_languages();

/// "team", the example team; "minimal", a few lines; "high-level", on behaviors and the planner of
/// the proxy; "rl", a policy with weights to train.
const std::vector<std::string_view>& project_templates();

/// All files of a project. The error names an unknown language or template.
base::Result<std::vector<ProjectFile>> project_files(std::string_view language,
                                                     std::string_view name,
                                                     std::string_view team_template);

}  // namespace cls::cli
