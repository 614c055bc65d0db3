// Members of the JSON of a setup.
#include "playground/setup.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "analysis/situations/book_file.h"
#include "base/text/json_document.h"

namespace cls::playground {
namespace {

using base::Error;
using base::JsonValue;
using base::Result;
using soccer::Side;

constexpr double kLargestSeed = 9007199254740991.0;  // the largest whole number of JavaScript
constexpr int kMostCycles = 1'000'000;
constexpr int kMostSituations = 1000;

Result<std::string> text_member(const JsonValue& root, std::string_view key) {
  if (!root.has(key)) return std::string();
  return root[key].string();
}

Result<std::uint64_t> seed_of(const JsonValue& root) {
  if (!root.has("seed")) return std::uint64_t{0};
  TRY_INIT(const double seed, root["seed"].number(0.0, kLargestSeed));
  if (seed != std::floor(seed)) return root["seed"].error("must be a whole number");
  return static_cast<std::uint64_t>(seed);
}

Result<std::vector<std::string>> settings_of(const JsonValue& root) {
  std::vector<std::string> settings;
  if (!root.has("set")) return settings;
  const JsonValue list = root["set"];
  if (!list.is_array()) return list.error("must be an array of settings");
  for (std::size_t i = 0; i < list.size(); ++i) {
    TRY_INIT(auto setting, list[i].string());
    settings.push_back(std::move(setting));
  }
  return settings;
}

Result<std::shared_ptr<const analysis::Book>> book_of(const JsonValue& root) {
  if (!root.has("book")) return std::shared_ptr<const analysis::Book>();
  TRY_INIT(const std::string text, root["book"].string());
  auto book = analysis::parse_book(text);
  if (!book) return root["book"].error(book.error().message);
  return std::make_shared<const analysis::Book>(*std::move(book));
}

std::string default_name(std::string_view side) {
  const std::size_t colon = side.find(':');
  return soccer::team_name_from(colon == std::string_view::npos ? side : side.substr(colon + 1));
}

}  // namespace

Result<MatchSetup> parse_setup(std::string_view json) {
  TRY_INIT(const auto document, base::JsonDocument::parse("match", std::string(json)));
  const JsonValue root(document);
  TRY(root.expect_keys({"left", "right", "leftName", "rightName", "seed", "cycles", "set", "book",
                        "situations", "view", "decisions"}));

  MatchSetup setup;
  for (const auto& [key, name_key, side] : {std::tuple("left", "leftName", Side::kLeft),
                                            std::tuple("right", "rightName", Side::kRight)}) {
    if (!root.has(key)) return root.error(fmt::format("'{}' is missing", key));
    TRY_INIT(setup.sides[side], root[key].string());
    TRY_INIT(setup.names[side], text_member(root, name_key));
  }

  TRY_INIT(setup.seed, seed_of(root));
  if (root.has("cycles")) {
    TRY_INIT(setup.cycles, root["cycles"].integer(1, kMostCycles));
  }
  TRY_INIT(setup.settings, settings_of(root));
  TRY_INIT(setup.book, book_of(root));
  if (setup.book != nullptr) {
    for (const char* key : {"situations", "cycles"}) {
      if (!root.has(key)) return root.error(fmt::format("'book' needs '{}'", key));
    }
    TRY_INIT(setup.situations, root["situations"].integer(1, kMostSituations));
  }
  if (root.has("view")) {
    TRY_INIT(setup.view, root["view"].boolean());
  }
  if (root.has("decisions")) {
    TRY_INIT(setup.decisions, root["decisions"].boolean());
  }
  return setup;
}

Result<soccer::TeamNames> team_names(const MatchSetup& setup) {
  soccer::TeamNames names;
  for (const Side side : soccer::kBothSides) {
    const std::string& given = setup.names[side];
    if (given.empty()) {
      names[side] = default_name(setup.sides[side]);
      continue;
    }
    TRY_INIT(names[side], soccer::check_team_name(given));
  }
  return soccer::distinct_names(std::move(names.left), std::move(names.right));
}

}  // namespace cls::playground
