// Asks the loader of the host which libraries a file needs, and copies them.
#include "cli/project/bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "base/io/whole_file.h"
#include "base/text/replace_all.h"
#include "cli/project/elf_file.h"
#include "cli/project/project_files.h"
#include "cli/support/run_program.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Result;

// A line of the loader's list: `libm.so.6 => /lib/libm.so.6 (0x00007f...)`.
struct ListedLibrary {
  std::string name;
  fs::path path;  ///< empty: not found
};

std::optional<ListedLibrary> listed_library(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  const std::size_t arrow = line.find(" => ");
  if (first == std::string_view::npos || arrow == std::string_view::npos) return std::nullopt;
  const std::string_view path = line.substr(arrow + 4);
  ListedLibrary listed{std::string(line.substr(first, arrow - first)), {}};
  if (path.starts_with("/")) listed.path = path.substr(0, path.rfind(" ("));
  return listed;
}

bool is_below(const fs::path& folder, const fs::path& path) {
  const fs::path relative = path.lexically_normal().lexically_relative(folder);
  return !relative.empty() && *relative.begin() != "..";
}

bool same_bytes(const fs::path& one, const fs::path& other) {
  std::error_code code;
  if (fs::equivalent(one, other, code)) return true;
  return base::read_file(one) == base::read_file(other);
}

bool may_be_elf(const fs::directory_entry& entry) {
  if (!entry.is_regular_file() || entry.is_symlink()) return false;
  const bool runs = (entry.status().permissions() & fs::perms::owner_exec) != fs::perms::none;
  return runs || entry.path().filename().string().find(".so") != std::string::npos;
}

}  // namespace

fs::path loader_of(const fs::path& program) {
  const auto file = read_elf_file(program);
  return file ? fs::path(file->loader) : fs::path();
}

Result<Bundle> Bundle::create(const fs::path& package, const fs::path& loader) {
  Bundle bundle;
  bundle.package_ = fs::absolute(package).lexically_normal();
  bundle.loader_ = loader;
  TRY(base::create_folders(bundle.package_ / "lib"));
  fs::copy_file(fs::canonical(loader), bundle.package_ / "lib" / loader.filename());
  fs::permissions(bundle.package_ / "lib" / loader.filename(), fs::perms(0755));
  return bundle;
}

Result<void> Bundle::add_library(const std::string& name, const fs::path& path,
                                 const fs::path& file) {
  if (is_below(package_, path) || name.starts_with("linux-vdso") || name == loader_.filename()) {
    return {};
  }
  const auto [known, is_new] = libraries_.emplace(name, path);
  if (is_new) {
    fs::copy_file(fs::canonical(path), package_ / "lib" / name);
    return {};
  }
  if (same_bytes(known->second, path)) return {};
  return base::Error{
      fmt::format("{}: two different libraries, {} and {}, the latter for {}; make the environment "
                  "with the interpreter of the system, or use the one-file program of make package",
                  name, known->second.string(), path.string(), file.string())};
}

// As ldd asks: `--list` would fail at the first library that is missing, and a file that is loaded
// only on demand may need some that no host has.
Result<void> Bundle::add_libraries(const fs::path& file) {
  TRY_INIT(const auto lines, run_program(fmt::format("{} {}", loader_.string(), file.string()),
                                         {"/usr/bin/env", "LD_TRACE_LOADED_OBJECTS=1",
                                          loader_.string(), file.string()}));
  for (const std::string& line : lines) {
    const auto listed = listed_library(line);
    if (!listed) continue;
    if (listed->path.empty()) {
      missing_.push_back(
          fmt::format("{}: {}", file.lexically_relative(package_).string(), listed->name));
    } else {
      TRY(add_library(listed->name, listed->path, file));
    }
  }
  return {};
}

Result<void> Bundle::write_script(const fs::path& target, const fs::path& script,
                                  const std::string& settings) {
  std::string up;
  for (auto part = std::next(script.begin()); part != script.end(); ++part) up += "/..";
  std::string text(embedded_file("cli/project/league/program"));
  base::replace_all(text, "@PROGRAM@", target.string());
  base::replace_all(text, "@SCRIPT@", script.string());
  base::replace_all(text, "@UP@", up);
  base::replace_all(text, "@SETTINGS@\n", settings);
  base::replace_all(text, "@LOADER@", loader_.filename().string());
  TRY(base::write_file(package_ / script, text));
  fs::permissions(package_ / script, fs::perms(0755));
  return {};
}

Result<void> Bundle::add_program(const fs::path& program, const fs::path& target,
                                 const fs::path& script, const std::string& settings) {
  const fs::path loader = loader_of(program);
  if (loader != loader_) {
    return base::Error{fmt::format("{}: its loader is '{}', that of cls is '{}'", program.string(),
                                   loader.string(), loader_.string())};
  }
  TRY(add_libraries(program));
  programs_.insert(package_ / target);
  TRY(base::create_folders((package_ / target).parent_path()));
  TRY(base::create_folders((package_ / script).parent_path()));
  if (program != package_ / target) fs::copy_file(fs::canonical(program), package_ / target);
  return write_script(target, script, settings);
}

Result<void> Bundle::add_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(package_ / folder)) {
    if (may_be_elf(entry)) files.push_back(entry.path());
  }

  std::ranges::sort(files);

  for (const fs::path& path : files) {
    const auto file = read_elf_file(path);
    if (!file || file->needed.empty()) continue;
    if (file->loader.empty()) {
      TRY(add_libraries(path));
      continue;
    }
    if (loads_on_oldest(*file) || programs_.count(path) != 0) continue;
    // The script has the date of the program: builds compare it with that of the sources.
    const auto date = fs::last_write_time(path);
    const fs::path target = path.string() + ".program";
    fs::rename(path, target);
    TRY(add_program(target, target.lexically_relative(package_),
                    path.lexically_relative(package_)));
    fs::last_write_time(path, date);
  }
  return {};
}

}  // namespace cls::cli
