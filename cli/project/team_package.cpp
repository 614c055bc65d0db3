// Fills in the embedded scripts and copies files.
#include "cli/project/team_package.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>

#include "base/io/gzip_sink.h"
#include "base/io/whole_file.h"
#include "base/text/replace_all.h"
#include "cli/project/bundle.h"
#include "cli/project/elf_file.h"
#include "cli/project/project_copy.h"
#include "cli/project/project_files.h"
#include "cli/support/run_program.h"
#include "match/terms/run_command.h"
#include "process/command_plan.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Result;

constexpr std::chrono::seconds kBuildLimit{1800};
constexpr const char* kScript = "./run";                        // of a project of `cls new`
constexpr const char* kPublished = ".build/publish/Team";       // by its step `publish`
constexpr const char* kLoader = "/lib64/ld-linux-x86-64.so.2";  // if cls itself needs none

Result<void> write_program(const fs::path& path, std::string_view text) {
  if (auto written = base::write_file(path, text); !written) return written;
  fs::permissions(path, fs::perms(0755));
  return {};
}

// Counts what passes through it.
class CountingSink : public base::ByteSink {
 public:
  explicit CountingSink(std::uintmax_t& bytes) : bytes_(bytes) {}
  void write(std::string_view bytes) override { bytes_ += bytes.size(); }
  Result<void> close() override { return {}; }

 private:
  std::uintmax_t& bytes_;
};

// Adds the sizes of the files of a package or of a part of it, and compresses them.
std::uintmax_t size_of(const fs::path& folder, base::ByteSink& packed) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_symlink() || !entry.is_regular_file()) continue;
    const auto content = base::read_file(entry.path());
    if (!content) continue;
    bytes += content->size();
    packed.write(*content);
  }
  return bytes;
}

Result<void> measure(const fs::path& folder, WrittenPackage& written) {
  base::GzipSink packed(std::make_unique<CountingSink>(written.packed_bytes));
  written.project_bytes = size_of(folder / "team", packed);
  if (fs::exists(folder / "env")) written.environment_bytes = size_of(folder / "env", packed);
  for (const char* part : {"bin", "lib"}) {
    if (fs::exists(folder / part)) written.program_bytes += size_of(folder / part, packed);
  }
  const auto program = base::read_file(folder / "cls").value_or("");
  written.program_bytes += program.size();
  packed.write(program);
  return packed.close();
}

// Symbols are for debuggers: most of the size of a build that was not installed.
Result<void> copy_stripped(const fs::path& program, const fs::path& to) {
  TRY(base::create_folders(to.parent_path()));
  if (const auto strip = process::find_program("strip")) {
    const auto stripped =
        run_program("strip", {strip->string(), "-o", to.string(), program.string()});
    if (stripped && fs::exists(to)) return {};
  }
  fs::copy_file(program, to, fs::copy_options::overwrite_existing);
  return {};
}

Result<Bundle> write_programs(const TeamPackage& package, const fs::path& folder) {
  const fs::path loader = loader_of(package.program);
  TRY_INIT(Bundle bundle, Bundle::create(folder, loader.empty() ? kLoader : loader));
  const auto file = read_elf_file(package.program);
  if (file && loads_on_oldest(*file)) {
    TRY(copy_stripped(package.program, folder / "cls"));
    return bundle;
  }
  TRY(copy_stripped(package.program, folder / "bin/cls"));
  TRY(bundle.add_program(fs::absolute(folder / "bin/cls").lexically_normal(), "bin/cls", "cls",
                         "export CLS_PROGRAM=\"$here/cls\"\n"));
  return bundle;
}

Result<void> bring_interpreters(const TeamPackage& package, const fs::path& folder, Bundle& bundle,
                                const PackageStep& on_step, WrittenPackage& written) {
  const InterpretedProject project{package.command, package.project, package.environment};
  std::vector<fs::path> programs = interpreters_of(project);
  for (const std::string& name : package.with) {
    TRY_INIT(fs::path found, process::find_program(name));
    programs.push_back(std::move(found));
  }
  for (const fs::path& program : programs) {
    on_step(fmt::format("copying {} with what it needs", program.string()));
    TRY_INIT(auto brought, bring_interpreter(program, project, folder, bundle));
    written.interpreters.push_back(std::move(brought));
  }
  if (!programs.empty()) TRY(bundle.add_folder("env"));
  return {};
}

// Lets the script of a project build before its files are copied, in C# one program instead of
// themselves. Returns the command that starts the Playmaker.
Result<std::string> build_project(const TeamPackage& package, const PackageStep& on_step) {
  const fs::path script = package.project / kScript;
  const auto text = base::read_file(script);
  if (!package.command.starts_with(std::string(kScript) + ' ') || !text) return package.command;

  const bool publishes =
      is_for_dotnet(package.project) && text->find("publish") != std::string::npos;
  const std::string step = publishes ? "publish" : "build";
  const std::string name = fmt::format("{} {}", kScript, step);
  on_step(name);
  TRY_INIT([[maybe_unused]] const auto lines,
           run_program(name, {script.string(), step}, kBuildLimit));
  if (!publishes) return package.command;
  return kPublished + package.command.substr(std::string_view(kScript).size());
}

}  // namespace

std::string start_script(const TeamPackage& package) {
  std::string command = package.command;
  base::replace_all(command, "{port}", "\"$port\"");

  match::RunValues values;
  values.team_name = package.name;

  std::string script = std::string(embedded_file("cli/project/league/start"));
  base::replace_all(script, "@NAME@", package.name);
  base::replace_all(script, "@COMMAND@", match::fill_in(command, values));
  return script;
}

fs::path environment_of(const fs::path& project) {
  const char* active = std::getenv("VIRTUAL_ENV");
  std::error_code code;
  for (const fs::path& one : {fs::path(active == nullptr ? "" : active), project / ".venv"}) {
    if (!one.empty() && fs::is_regular_file(one / "pyvenv.cfg", code)) return one;
  }
  return {};
}

namespace {

Result<WrittenPackage> write_unfinished(TeamPackage package, const fs::path& folder,
                                        const PackageStep& on_step) try {
  WrittenPackage written;
  TRY_INIT(package.command, build_project(package, on_step));
  TRY(base::create_folders(folder));
  TRY(write_program(folder / "start", start_script(package)));
  TRY(write_program(folder / "kill", embedded_file("cli/project/league/kill")));
  TRY_INIT(Bundle bundle, write_programs(package, folder));
  TRY(write_program(folder / "lib/machine.sh", embedded_file("cli/project/league/machine.sh")));
  CopiedProject copied = copy_project(package, folder / "team");
  written.left_out = std::move(copied.left_out);
  written.links_outside = std::move(copied.links_outside);
  TRY(bring_interpreters(package, folder, bundle, on_step, written));
  TRY(bundle.add_folder("team"));

  written.missing = bundle.missing();
  on_step("compressing, for its size");
  TRY(measure(folder, written));
  return written;
} catch (const fs::filesystem_error& error) {
  return base::Error{fmt::format("{}: {}", error.path1().string(), error.code().message())};
}

}  // namespace

Result<WrittenPackage> write_package(const TeamPackage& package, const fs::path& dir,
                                     const PackageStep& on_step) {
  fs::path folder = fs::absolute(dir).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // "ada-team/"
  const fs::path unfinished = folder.string() + ".unfinished";
  std::error_code code;
  fs::remove_all(unfinished, code);  // of one that was killed
  auto written = write_unfinished(package, unfinished, on_step);
  if (written) {
    fs::rename(unfinished, folder, code);
    if (code) written = base::Error{fmt::format("{}: {}", folder.string(), code.message())};
  }
  if (!written) fs::remove_all(unfinished, code);
  return written;
}

}  // namespace cls::cli
