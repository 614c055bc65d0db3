// `cls test --export`: writes the shipped scenarios.
#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/io/occupied_path.h"
#include "base/io/whole_file.h"
#include "cli/match/test_arguments.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "scenario/scenario_library.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

// Files of the folder that differ from the shipped ones of the same name.
std::vector<fs::path> edited_files(const fs::path& folder) {
  std::vector<fs::path> edited;
  std::error_code code;
  for (const auto& file : scenario::shipped_files()) {
    const fs::path path = folder / file.name;
    if (fs::exists(path, code) && base::read_file(path) != file.text) edited.push_back(path);
  }
  return edited;
}

}  // namespace

int export_scenarios(const TestArguments& arguments) {
  const fs::path folder = arguments.export_folder;
  TRY_OR(kCannotCreate, base::create_folders(folder));

  const std::vector<fs::path> edited = edited_files(folder);
  if (!edited.empty() && !arguments.force) {
    for (const fs::path& file : edited) {
      print_error(0, "{}: differs from the shipped scenario", file.string());
    }
    return print_error(kCannotCreate,
                       "nothing written; --force renames these files to NAME.old first");
  }

  for (const fs::path& file : edited) {
    TRY_INIT_OR(kCannotCreate, const auto kept, base::set_aside(file));
    fmt::print(stderr, "cls: {} renamed to {}\n", file.string(), kept.filename().string());
  }

  for (const auto& file : scenario::shipped_files()) {
    TRY_OR(kCannotCreate, base::write_file(folder / file.name, file.text));
  }

  const std::size_t count = scenario::shipped_files().size();
  if (arguments.json)
    return print_json({{"schema", "cls.export/1"}, {"dir", folder.string()}, {"files", count}});

  fmt::print("{} files in {}\n", count, folder.string());

  return kOk;
}

}  // namespace cls::cli
