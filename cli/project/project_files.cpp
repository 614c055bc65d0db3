// Selects and renames embedded files, and fills in names.
#include "cli/project/project_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/text/replace_all.h"
#include "base/text/suggestion.h"

namespace cls::cli {
namespace {

struct Language {
  std::string_view folder;    ///< of examples/
  std::string_view name;      ///< as its users write it
  std::string_view decide;    ///< the file of decisions, in the project
  std::string_view packages;  ///< of Debian, for the project's CI
  std::string_view setup;     ///< steps of that CI for tools that Debian 12 lacks
  std::string_view launch;    ///< lines of .vscode/launch.json
};

constexpr Language kLanguages[] = {
    {"python", "Python", "decide.py", "python3-grpcio python3-protobuf protobuf-compiler-grpc", "",
     "      \"type\": \"debugpy\",\n"
     "      \"program\": \"${workspaceFolder}/playmaker.py\",\n"
     "      \"env\": {\"PYTHONPATH\": \"${workspaceFolder}/.build\", \"PYTHONDONTWRITEBYTECODE\": "
     "\"1\"},\n"},
    {"javascript", "JavaScript", "src/decide.js", "xz-utils",
     "      - uses: actions/setup-node@v4\n"
     "        with: {node-version: 20}\n",
     "      \"type\": \"node\",\n"
     "      \"program\": \"${workspaceFolder}/src/main.js\",\n"},
    {"typescript", "TypeScript", "src/decide.ts", "xz-utils",
     "      - uses: actions/setup-node@v4\n"
     "        with: {node-version: 20}\n",
     "      \"type\": \"node\",\n"
     "      \"program\": \"${workspaceFolder}/.build/js/main.js\",\n"
     "      \"outFiles\": [\"${workspaceFolder}/.build/js/**/*.js\"],\n"
     "      \"env\": {\"PROTO\": \"${workspaceFolder}/proto\"},\n"},
    {"go", "Go", "decide.go", "protobuf-compiler",
     "      - uses: actions/setup-go@v5\n"
     "        with: {go-version: '1.26', cache: false}\n",
     "      \"type\": \"go\",\n"
     "      \"mode\": \"debug\",\n"
     "      \"program\": \"${workspaceFolder}\",\n"},
    {"java", "Java", "src/main/java/team/Decide.java", "openjdk-17-jdk-headless maven", "",
     "      \"type\": \"java\",\n"
     "      \"mainClass\": \"team.Main\",\n"
     "      \"classPaths\": [\"${workspaceFolder}/.build/classes\", "
     "\"${workspaceFolder}/.build/lib/*\"],\n"},
    {"rust", "Rust", "src/decide.rs", "curl",
     "      - uses: dtolnay/rust-toolchain@master\n"
     "        with: {toolchain: '1.88'}\n",
     "      \"type\": \"lldb\",\n"
     "      \"cargo\": {\"args\": [\"build\"], \"env\": {\"CARGO_TARGET_DIR\": "
     "\"${workspaceFolder}/.build\"}},\n"},
    {"csharp", "C#", "Decide.cs", "ca-certificates curl libicu72",
     "      - uses: actions/setup-dotnet@v4\n"
     "        with: {dotnet-version: 8.0.x}\n",
     "      \"type\": \"dotnet\",\n"
     "      \"projectPath\": \"${workspaceFolder}/Team.csproj\",\n"},
};

constexpr std::string_view kTeam = "team";
constexpr std::string_view kPolicy = "rl";

// Of the README of a project with a policy.
constexpr std::string_view kTrainingLines =
    "## Train it\n"
    "\n"
    "`policy.txt` has the weights by which the player with the ball chooses. `train.py` changes "
    "them at\n"
    "random, plays, and stores what is not worse: about half a minute a round, with the score of "
    "each match.\n"
    "\n"
    "```sh\n"
    "python3 train.py --rounds 20\n"
    "```\n"
    "\n";

// Names of files that version control and editors would use inside the source tree of cls itself.
constexpr std::pair<std::string_view, std::string_view> kRenamed[] = {
    {"gitignore", ".gitignore"},
    {"editorconfig", ".editorconfig"},
    {"launch.json", ".vscode/launch.json"},
    {"tasks.json", ".vscode/tasks.json"},
    {"test.yml", ".github/workflows/test.yml"},
};

const Language* find_language(std::string_view folder) {
  const auto* found = std::ranges::find(kLanguages, folder, &Language::folder);
  return found == std::end(kLanguages) ? nullptr : found;
}

// The rest of `name` after `folder`.
std::optional<std::string> inside(std::string_view name, std::string_view folder) {
  if (name.substr(0, folder.size()) != folder) return std::nullopt;
  return std::string(name.substr(folder.size()));
}

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

bool is_decide(std::string_view file) {
  return std::ranges::any_of(kLanguages,
                             [&](const Language& each) { return file_name(each.decide) == file; });
}

// Path in the project of an embedded file; nothing if the project lacks it. A template other than
// the team replaces its decisions, and may add files.
std::optional<std::string> project_path(std::string_view name, const Language& language,
                                        std::string_view team_template) {
  if (const auto path = inside(name, "examples/project/")) {
    for (const auto& [from, to] : kRenamed) {
      if (*path == from) return std::string(to);
    }
    return path;
  }

  if (const auto path = inside(name, "proto/")) return "proto/" + *path;
  if (const auto path = inside(name, "python/")) {
    if (language.folder != "python") return std::nullopt;
    return "package/" + *path;  // beside the program it would hide the generated modules
  }

  if (auto path = inside(name, fmt::format("examples/{}/", team_template))) {
    if (*path == file_name(language.decide)) return std::string(language.decide);
    return is_decide(*path) ? std::nullopt : path;
  }

  const auto path = inside(name, fmt::format("examples/{}/", language.folder));
  if (path && team_template != kTeam && *path == language.decide) return std::nullopt;
  return path;
}

// Fills in the name, and moves no comment behind it out of its column.
std::string with_name(std::string_view text, std::string_view name) {
  constexpr std::string_view kComment = "  # ";
  std::string filled;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string line(text.substr(0, end));
    text.remove_prefix(end);

    const std::size_t before = line.find(kComment);
    base::replace_all(line, "@NAME@", name);
    const std::size_t after = line.find(kComment);
    if (after < before) line.insert(after, before - after, ' ');
    if (after > before) line.erase(before, after - before);
    filled += line;
  }
  return filled;
}

std::string filled_in(std::string_view text, std::string_view name, const Language& language,
                      std::string_view team_template) {
  std::string filled(text);
  base::replace_all(filled, "@TRAINING@\n", team_template == kPolicy ? kTrainingLines : "");
  filled = with_name(filled, name);
  base::replace_all(filled, "@LANGUAGE@", language.name);
  base::replace_all(filled, "@DECIDE@", language.decide);
  base::replace_all(filled, "@PACKAGES@", language.packages);
  base::replace_all(filled, "@SETUP@\n", language.setup);
  base::replace_all(filled, "@LAUNCH@\n", language.launch);
  return filled;
}

base::Error unknown(std::string_view what, std::string_view word,
                    const std::vector<std::string_view>& names) {
  return {fmt::format("unknown {} '{}': {}{}", what, word, fmt::join(names, ", "),
                      base::did_you_mean(word, names))};
}

}  // namespace

std::string_view embedded_file(std::string_view name) {
  const auto& files = embedded_files();
  const auto found = std::ranges::find(files, name, &EmbeddedFile::name);
  return found == files.end() ? std::string_view() : found->text;
}

const std::vector<std::string_view>& project_languages() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const Language& language : kLanguages) all.push_back(language.folder);
    return all;
  }();
  return names;
}

const std::vector<std::string_view>& project_templates() {
  static const std::vector<std::string_view> names = {kTeam, "minimal", "high-level", kPolicy};
  return names;
}

base::Result<std::vector<ProjectFile>> project_files(std::string_view language_name,
                                                     std::string_view name,
                                                     std::string_view team_template) {
  const Language* language = find_language(language_name);
  if (language == nullptr) return unknown("language", language_name, project_languages());

  const auto& templates = project_templates();
  if (std::ranges::find(templates, team_template) == templates.end()) {
    return unknown("template", team_template, templates);
  }

  std::vector<ProjectFile> files;
  for (const EmbeddedFile& file : embedded_files()) {
    auto path = project_path(file.name, *language, team_template);
    if (path)
      files.push_back({std::move(*path), filled_in(file.text, name, *language, team_template)});
  }
  return files;
}

}  // namespace cls::cli
