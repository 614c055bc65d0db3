// Knows Python and Node.js; copies any other program with its libraries.
#include "cli/project/interpreters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "base/io/whole_file.h"
#include "cli/project/elf_file.h"
#include "cli/project/project_files.h"
#include "cli/support/run_program.h"
#include "process/command_plan.h"
#include "process/scratch_folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Result;

// Files of a project that say which language its Playmaker is in, if it is not Python.
constexpr std::array kOtherLanguages = {"go.mod", "Cargo.toml", "package.json", "pom.xml"};
constexpr const char* kWherePython =
    "import os, sys; print(os.path.realpath(getattr(sys, '_base_executable', sys.executable))); "
    "print('%d.%d' % sys.version_info[:2])";

bool has_ending(const fs::path& folder, std::string_view ending) {
  std::error_code code;
  const fs::directory_iterator files(folder, code);
  return std::ranges::any_of(files, [ending](const fs::directory_entry& entry) {
    return entry.path().extension() == ending;
  });
}

bool is_for_python(const InterpretedProject& project) {
  if (!project.environment.empty() || project.command.find("python") != std::string::npos) {
    return true;
  }
  const bool other =
      is_for_dotnet(project.folder) || std::ranges::any_of(kOtherLanguages, [&](const char* name) {
        return fs::exists(project.folder / name);
      });
  return !other && has_ending(project.folder, ".py");
}

bool is_for_node(const InterpretedProject& project) {
  return fs::exists(project.folder / "package.json") ||
         project.command.find("node ") != std::string::npos;
}

bool imports_grpc(const fs::path& python) {
  return bool(
      run_program(python.string(), {python.string(), "-c", "import grpc, google.protobuf"}));
}

// That of the environment; of a project of `cls new` the first that its script `run` would choose.
fs::path python_of(const InterpretedProject& project) {
  std::vector<fs::path> candidates;
  if (!project.environment.empty()) {
    candidates.push_back(project.environment / "bin/python");
    if (!fs::exists(project.folder / "run")) return candidates.front();
  }
  for (const char* name : {"python3", "/usr/bin/python3"}) {
    if (auto found = process::find_program(name)) candidates.push_back(*found);
  }
  const auto chosen = std::ranges::find_if(candidates, imports_grpc);
  if (chosen != candidates.end()) return *chosen;
  return candidates.empty() ? fs::path() : candidates.front();
}

// Scripts of an environment name its interpreter by its path on this host.
Result<void> copy_scripts(const fs::path& environment, const fs::path& to) {
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(environment / "bin", code)) {
    const std::string name = entry.path().filename().string();
    const auto text = entry.is_symlink() ? std::nullopt : base::read_file(entry.path());
    const bool is_tool = name.starts_with("pip") || name.starts_with("python");
    if (!text || !text->starts_with("#!") || is_tool || fs::exists(to / name)) continue;
    const std::size_t end = std::min(text->find('\n'), text->size());
    const bool is_python = text->substr(0, end).find("python") != std::string::npos;
    TRY(base::write_file(to / name,
                         is_python ? "#!/usr/bin/env python3" + text->substr(end) : *text));
    fs::permissions(to / name, fs::perms(0755));
  }
  return {};
}

Result<BroughtInterpreter> bring_python(const fs::path& program, const InterpretedProject& project,
                                        const fs::path& package, Bundle& bundle) {
  TRY_INIT(const auto facts, run_program(program.string(), {program.string(), "-c", kWherePython}));
  if (facts.size() < 2) return base::Error{fmt::format("{}: is not Python", program.string())};
  BroughtInterpreter brought{"python3", facts[0], {}};
  const std::string versioned = "python" + facts[1];
  TRY(bundle.add_program(facts[0], "env/libexec/" + versioned, "env/bin/python3",
                         "export PYTHONHOME=\"$here/env\" PYTHONNOUSERSITE=1 "
                         "PYTHONDONTWRITEBYTECODE=1\n"));
  for (const std::string& name : {std::string("python"), versioned}) {
    fs::create_symlink("python3", package / "env/bin" / name);
  }

  TRY_INIT(const auto scratch, process::ScratchFolder::create());
  const fs::path script = scratch.path() / "python_files.py";
  TRY(base::write_file(script, embedded_file("cli/project/league/python_files.py")));
  TRY_INIT(const auto lines,
           run_program(fmt::format("{}: packages", program.string()),
                       {program.string(), script.string(), (package / "team").string(),
                        project.environment.string(), (package / "env").string()},
                       std::chrono::seconds(600)));
  for (const std::string& line : lines) {
    const std::string name = line.substr(0, line.find('\t'));
    if (!name.ends_with("-info") && !name.ends_with(".libs")) brought.packages.push_back(name);
  }

  if (!project.environment.empty()) {
    TRY(copy_scripts(project.environment, package / "env/bin"));
  }

  return brought;
}

}  // namespace

bool is_for_dotnet(const fs::path& folder) { return has_ending(folder, ".csproj"); }

std::vector<fs::path> interpreters_of(const InterpretedProject& project) {
  std::vector<fs::path> programs;
  if (is_for_python(project)) {
    if (fs::path python = python_of(project); !python.empty()) programs.push_back(python);
  }
  if (is_for_node(project)) {
    if (const auto node = process::find_program("node")) programs.push_back(*node);
  }
  return programs;
}

Result<BroughtInterpreter> bring_interpreter(const fs::path& program,
                                             const InterpretedProject& project,
                                             const fs::path& package, Bundle& bundle) {
  const std::string name = program.filename().string();
  if (name.starts_with("python")) return bring_python(program, project, package, bundle);

  const fs::path real = fs::canonical(program);
  const auto file = read_elf_file(real);
  if (!file)
    return base::Error{fmt::format("{}: is not a program of Linux for x86-64", real.string())};
  TRY(base::create_folders(package / "env/bin"));
  if (loads_on_oldest(*file)) {
    fs::copy_file(real, package / "env/bin" / name);
  } else {
    TRY(bundle.add_program(real, "env/libexec/" + name, "env/bin/" + name));
  }
  return BroughtInterpreter{name, real, {}};
}

}  // namespace cls::cli
