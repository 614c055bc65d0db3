// Rows of numbers by the tables of training/.
#include "match/sides/policy_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/index.h"
#include "training/actions/action_set.h"
#include "training/features/feature_set.h"
#include "training/scene/estimated_scene.h"
#include "training/scene/openings.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;
using training::Cast;
using training::PointOfView;

constexpr int kMaxTeammates = 10;
constexpr int kMaxOpponents = 11;

// Options are more than the command of the body that a row can ask for.
bool fits_a_row(const training::FeatureSet& set) { return !set.needs_options; }
bool fits_a_row(const training::ActionSet& set) { return !set.options; }

template <typename Sets>
std::vector<std::string> versioned_names(const Sets& sets) {
  std::vector<std::string> names;
  for (const auto* set : sets) {
    if (fits_a_row(*set)) names.push_back(fmt::format("{}/{}", set->name, set->version));
  }
  return names;
}

// A set by NAME/VERSION.
template <typename Sets>
auto find_versioned(const Sets& sets, std::string_view name) {
  const auto found = std::ranges::find_if(sets, [name](const auto* set) {
    return fits_a_row(*set) && name == fmt::format("{}/{}", set->name, set->version);
  });
  return found == sets.end() ? nullptr : *found;
}

class PolicyRows : public proxy::TensorCodec {
 public:
  std::shared_ptr<proxy::TensorCodec> clone() const override {
    return std::make_shared<PolicyRows>(*this);
  }

  std::vector<std::string> feature_sets() const override {
    return versioned_names(training::feature_sets());
  }
  std::vector<std::string> action_sets() const override {
    return versioned_names(training::action_sets());
  }

  Result<proxy::TensorSizes> choose(const proxy::TensorChoice& choice) override {
    features_ = find_versioned(training::feature_sets(), choice.feature_set);
    if (features_ == nullptr) {
      return Error{fmt::format("the feature set '{}', which was not offered", choice.feature_set)};
    }
    actions_ = find_versioned(training::action_sets(), choice.action_set);
    if (actions_ == nullptr) {
      return Error{fmt::format("the action set '{}', which was not offered", choice.action_set)};
    }
    if (choice.teammates < 0 || choice.teammates > kMaxTeammates || choice.opponents < 0 ||
        choice.opponents > kMaxOpponents) {
      return Error{fmt::format("{} teammates and {} opponents; the limits are {} and {}",
                               choice.teammates, choice.opponents, kMaxTeammates, kMaxOpponents)};
    }

    teammates_ = choice.teammates;
    opponents_ = choice.opponents;
    columns_ = features_->columns(teammates_, opponents_).size();
    values_ = actions_->values();
    offsets_ = actions_->offsets();
    legality_ = training::Legality(*actions_);
    const int ids = actions_->id_count();
    return proxy::TensorSizes{static_cast<int>(columns_), ids,
                              static_cast<int>(values_.size()) + (ids > 0 ? 1 : 0)};
  }

  void encode(const player::WorldModel& world, std::vector<float>& features,
              std::vector<std::uint8_t>& masks) override {
    PointOfView view = look(world);
    std::optional<training::Openings> openings;
    if (features_->needs_openings) view.openings = &openings.emplace(view.scene, view.cast);

    const std::size_t first = features.size();
    features.resize(first + columns_);
    features_->fill(view, features.data() + first);

    const std::size_t first_mask = masks.size();
    masks.resize(first_mask + actions_->actions.size());
    legality_.fill(view, masks.data() + first_mask);
  }

  std::optional<soccer::PlayerCommand> decode(const player::WorldModel& world,
                                              const float* row) override {
    const bool has_ids = actions_->id_count() > 0;
    const float* given = row + (has_ids ? 1 : 0);
    clipped_.clear();
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (!std::isfinite(given[i])) return std::nullopt;
      clipped_.push_back(std::clamp(given[i], values_[i].low, values_[i].high));
    }

    const PointOfView view = look(world);
    if (!has_ids) return actions_->choose(view, clipped_.data());

    const float number = row[0];
    if (!(number >= 0.0F && number < static_cast<float>(actions_->id_count()))) return std::nullopt;
    const auto id = static_cast<std::size_t>(number);
    const training::Action& action = actions_->actions[id];
    if (action.legal != nullptr && !action.legal(view)) return training::stand();
    return action.command(view, clipped_.data() + offsets_[id]);
  }

 private:
  PointOfView look(const player::WorldModel& world) {
    fill_scene(world, everybody_, scene_);
    const soccer::Side side = world.our_side;
    const int self = soccer::slot_of(side, world.unum);
    choose_players(side, self, teammates_, cast_.left);
    choose_players(soccer::opponent(side), self, opponents_, cast_.right);
    if (side == soccer::Side::kRight) std::swap(cast_.left, cast_.right);
    return {
        scene_, cast_, training::seat_of(side, self), {-soccer::kHalfLength, soccer::kHalfLength}};
  }

  // `count` players of a team, and the agent if it is the agent's.
  void choose_players(soccer::Side team, int self, int count, std::vector<int>& out) const {
    out = everybody_.team(team);
    const bool own = team == soccer::side_of_slot(self);
    const int most = own ? kMaxTeammates : kMaxOpponents;
    if (count == most) return;

    const auto rank = [&](int slot) {
      const training::ScenePlayer& player = seat(slot, self);
      if (slot == self) return -1.0;
      return player.seen ? squared_distance(player.position, seat(self, self).position) : 1e9;
    };
    std::ranges::stable_sort(out, {}, rank);
    out.resize(base::index(count + (own ? 1 : 0)));
  }

  const training::ScenePlayer& seat(int slot, int self) const {
    return scene_.player(training::seat_of(soccer::side_of_slot(self), slot));
  }

  Cast everybody_ = training::everybody();
  Cast cast_;  // of the current row
  training::Scene scene_;
  const training::FeatureSet* features_ = nullptr;
  const training::ActionSet* actions_ = nullptr;
  int teammates_ = 0;
  int opponents_ = 0;
  std::size_t columns_ = 0;
  training::Columns values_;
  std::vector<int> offsets_;
  training::Legality legality_;
  std::vector<float> clipped_;
};

}  // namespace

std::shared_ptr<proxy::TensorCodec> make_policy_rows() { return std::make_shared<PolicyRows>(); }

}  // namespace cls::match
