// Tensors to and from bytes.
#include "proxy/playmaker/tensor_calls.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <utility>

#include "base/index.h"
#include "base/overloaded.h"
#include "player/world/motion.h"

namespace cls::proxy {
namespace {

namespace wire = cls::playmaker::v1;

static_assert(std::endian::native == std::endian::little, "tensors are little-endian");

// Widens a tensor by one row.
template <typename Number>
void append_row(const std::vector<Number>& row, wire::Tensor& tensor) {
  if (tensor.shape().empty()) {
    tensor.add_shape(0);
    tensor.add_shape(static_cast<int>(row.size()));
  }
  tensor.set_shape(0, tensor.shape(0) + 1);
  tensor.mutable_data()->append(reinterpret_cast<const char*>(row.data()),
                                row.size() * sizeof(Number));
}

// The action of a body command. The list has it and the neck action that training has by default.
void fill(const soccer::PlayerCommand& command, const player::WorldModel& world,
          protos::PlayerAction& out) {
  const auto number = [](double value) { return static_cast<float>(value); };

  std::visit(base::Overloaded{
                 [&](const soccer::Dash& dash) {
                   out.mutable_dash()->set_power(number(dash.power));
                   out.mutable_dash()->set_relative_direction(number(dash.direction));
                 },
                 [&](const soccer::Turn& turn) {
                   const double angle = turn.moment / player::turn_resistance(world.self_type(),
                                                                              world.self.velocity);
                   out.mutable_turn()->set_relative_direction(number(angle));
                 },
                 [&](const soccer::Kick& kick) {
                   out.mutable_kick()->set_power(number(kick.power));
                   out.mutable_kick()->set_relative_direction(number(kick.direction));
                 },
                 [&](const soccer::Tackle& tackle) {
                   out.mutable_tackle()->set_power_or_dir(number(tackle.angle_or_power));
                   out.mutable_tackle()->set_foul(tackle.foul);
                 },
                 [&](const soccer::Catch&) { out.mutable_catch_(); },
                 [&](const soccer::Move& move) {
                   out.mutable_move()->set_x(number(move.x));
                   out.mutable_move()->set_y(number(move.y));
                 },
                 [](const auto&) {},
             },
             command);
}

}  // namespace

void TensorCalls::offer(const TeamRegistration& team, wire::RegisterTeamRequest& request) {
  request.set_rated(team.rated);
  if (team.codec == nullptr) return;
  request.add_encodings(wire::TENSOR);
  for (std::string& name : team.codec->feature_sets()) request.add_feature_sets(std::move(name));
  for (std::string& name : team.codec->action_sets()) request.add_action_sets(std::move(name));
}

base::Result<void> TensorCalls::choose(const TeamRegistration& team,
                                       const wire::RegisterTeamResponse& response) {
  codec_ = nullptr;
  if (response.encoding() != wire::TENSOR) return {};

  if (team.codec == nullptr) return base::Error{"it chose encoding 2, which was not offered"};
  std::shared_ptr<TensorCodec> codec = team.codec->clone();
  const base::Result<TensorSizes> sizes = codec->choose(
      {response.feature_set(), response.action_set(), response.teammates(), response.opponents()});
  if (!sizes) return base::Error{"it chose " + sizes.error().message};

  codec_ = std::move(codec);
  sizes_ = *sizes;
  return {};
}

void TensorCalls::add_player(const player::WorldModel& world, bool first,
                             wire::GetTeamActionsRequest& request) {
  if (first) request.set_play_mode(std::string(soccer::name(world.game.mode)));
  features_.clear();
  masks_.clear();
  codec_->encode(world, features_, masks_);
  append_row(features_, *request.mutable_features());
  append_row(masks_, *request.mutable_masks());
}

base::Result<void> TensorCalls::read(const wire::GetTeamActionsResponse& response,
                                     std::size_t players) {
  actions_.clear();
  const wire::Tensor& tensor = response.actions();
  if (tensor.data().empty()) return {};

  const std::size_t numbers = players * base::index(sizes_.actions);
  const bool fits = tensor.shape_size() == 2 && tensor.shape(0) == static_cast<int>(players) &&
                    tensor.shape(1) == sizes_.actions &&
                    tensor.data().size() == numbers * sizeof(float);
  if (!fits) {
    return base::Error{fmt::format("actions: {} bytes of shape [{}] are not {} x {} float32",
                                   tensor.data().size(), fmt::join(tensor.shape(), ", "), players,
                                   sizes_.actions)};
  }

  actions_.resize(numbers);
  std::memcpy(actions_.data(), tensor.data().data(), tensor.data().size());
  return {};
}

const protos::PlayerActions* TensorCalls::actions(std::size_t row,
                                                  const player::WorldModel& world) {
  const float* const numbers = actions_.data() + row * base::index(sizes_.actions);
  const auto command = codec_->decode(world, numbers);
  if (!command) return nullptr;

  list_.Clear();
  list_.set_ignore_preprocess(true);
  list_.set_ignore_doforcekick(true);
  list_.set_ignore_doheardpassrecieve(true);
  list_.set_ignore_dointention(true);
  list_.set_ignore_shootinpreprocess(true);
  fill(*command, world, *list_.add_actions());
  list_.add_actions()->mutable_neck_turn_to_ball_or_scan();
  return &list_;
}

}  // namespace cls::proxy
