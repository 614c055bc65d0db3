// Loads formation folders.
#include "player/formation/formation_set.h"

#include <cassert>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "base/index.h"
#include "base/io/whole_file.h"
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

/// Builds a set from what `read` returns for the file name of each kind.
template <typename Read>
Result<std::shared_ptr<const FormationSet>> make_set(const Read& read) {
  std::vector<Formation> list;
  for (const std::string_view name : kFileNames) {
    TRY_INIT(Formation formation, read(name));
    list.push_back(std::move(formation));
  }

  return std::shared_ptr<const FormationSet>(std::make_shared<FormationSet>(std::move(list)));
}

}  // namespace

std::string_view file_name(FormationKind kind) { return kFileNames[base::index(kind)]; }

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
      if (const auto text = base::read_text(path)) return parse_formation(*text, path);
    }
    return Error{folder + ": missing " + std::string(name) + ".formation or " + std::string(name) +
                 ".conf"};
  });
}

}  // namespace cls::player
