// Loads formation folders.
#include "player/formation/formation_set.h"

#include <cassert>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "base/io/whole_file.h"
#include "player/formation/built_in.h"
#include "player/formation/formation_file.h"

namespace cls::player {
namespace {

using base::Error;
using base::Result;

constexpr std::array<std::string_view, kFormationKindCount> kFileNames{
    "before-kick-off",
    "normal-formation",
    "defense-formation",
    "offense-formation",
    "goal-kick-our",
    "goal-kick-opp",
    "goalie-catch-our",
    "goalie-catch-opp",
    "kickin-our-formation",
    "setplay-our-formation",
    "setplay-opp-formation",
    "indirect-freekick-our-formation",
    "indirect-freekick-opp-formation",
};

std::array<Formation, kFormationKindCount> as_array(std::vector<Formation> list) {
  const auto take = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Formation, kFormationKindCount>{std::move(list[I])...};
  };
  return take(std::make_index_sequence<kFormationKindCount>());
}

/// Builds a set from what `read` returns for the file name of each kind.
template <typename Read>
Result<std::shared_ptr<const FormationSet>> make_set(const Read& read) {
  std::vector<Formation> list;
  for (const std::string_view name : kFileNames) {
    Result<Formation> formation = read(name);
    if (!formation) return formation.error();
    list.push_back(std::move(*formation));
  }

  return std::shared_ptr<const FormationSet>(
      std::make_shared<FormationSet>(as_array(std::move(list))));
}

std::optional<std::string> read_if_exists(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path) || !file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

std::string_view file_name(FormationKind kind) {
  return kFileNames[static_cast<std::size_t>(kind)];
}

std::shared_ptr<const FormationSet> built_in_formations() {
  static const std::shared_ptr<const FormationSet> set = [] {
    const auto made = make_set([](std::string_view name) {
      return parse_formation(built_in_formation(name), std::string(name));
    });
    assert(made && "the build embeds all formations, and a test reads them");
    return *made;
  }();
  return set;
}

Result<std::shared_ptr<const FormationSet>> read_formations(const std::string& folder) {
  if (const auto why = base::why_no_folder(folder)) return Error{folder + ": " + *why};
  return make_set([&](std::string_view name) -> Result<Formation> {
    for (const char* ending : {".formation", ".conf", ""}) {
      const std::string path =
          (std::filesystem::path(folder) / (std::string(name) + ending)).string();
      if (const auto text = read_if_exists(path)) return parse_formation(*text, path);
    }
    return Error{folder + ": missing " + std::string(name) + ".formation or " + std::string(name) +
                 ".conf"};
  });
}

}  // namespace cls::player
