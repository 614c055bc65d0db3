// Random actions of any kind, built by reflection.
#include "mock-server/behavior/bundled.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <type_traits>

#include "proto/field_access.h"
#include "proto/rpc.h"
#include "soccer/random.h"

namespace cls::mock_server {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using soccer::RandomStream;

constexpr int kMaxActions = 4;
constexpr int kMaxDepth = 4;
constexpr double kMaxValue = 100.0;  // meters, degrees, power: sometimes beyond every limit

void fill(Message& message, RandomStream& draw, int depth);

void fill_scalar(Message& message, const FieldDescriptor& field, RandomStream& draw) {
  if (const auto* names = field.enum_type()) {
    const auto* value = names->value(draw.integer(names->value_count()));
    return message.GetReflection()->SetEnum(&message, &field, value);
  }

  proto::with_access(field, [&](auto access) {
    using Value = typename decltype(access)::Value;
    if constexpr (std::is_same_v<Value, std::string>) {
      access.put(message, field, "random");
    } else if constexpr (std::is_same_v<Value, bool>) {
      access.put(message, field, draw.bernoulli(0.5));
    } else if constexpr (std::is_floating_point_v<Value>) {
      access.put(message, field, static_cast<Value>(draw.uniform(-kMaxValue, kMaxValue)));
    } else {
      access.put(message, field, static_cast<Value>(draw.integer(12)));
    }
  });
}

void fill_oneof(Message& message, RandomStream& draw, int depth) {
  const auto& choice = *message.GetDescriptor()->oneof_decl(0);
  const FieldDescriptor* field = choice.field(draw.integer(choice.field_count()));
  fill(*message.GetReflection()->MutableMessage(&message, field), draw, depth);
}

void fill(Message& message, RandomStream& draw, int depth) {
  const Descriptor& type = *message.GetDescriptor();
  if (depth > kMaxDepth) return;
  if (type.oneof_decl_count() > 0) return fill_oneof(message, draw, depth + 1);

  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (field.is_repeated()) continue;
    if (field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      fill(*message.GetReflection()->MutableMessage(&message, &field), draw, depth + 1);
    } else {
      fill_scalar(message, field, draw);
    }
  }
}

RandomStream stream_for(std::uint64_t seed, proto::Rpc rpc, const protos::State& state) {
  const protos::WorldModel& world = state.world_model();
  const auto clock = static_cast<std::uint64_t>(world.cycle()) << 32U |
                     static_cast<std::uint32_t>(world.time_stopped());
  return RandomStream(seed, name(rpc), static_cast<std::uint64_t>(caller_of(rpc, state).unum),
                      clock);
}

class RandomBehavior : public Behavior {
 public:
  explicit RandomBehavior(std::uint64_t seed) : seed_(seed) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override {
    RandomStream draw = stream_for(seed_, proto::Rpc::kGetPlayerActions, state);
    const int count = 1 + draw.integer(kMaxActions);
    for (int i = 0; i < count; ++i) fill(*actions.add_actions(), draw, 0);
    actions.set_ignore_preprocess(draw.bernoulli(0.5));
  }
  void decide_as_coach(const protos::State& state, protos::CoachActions& actions) const override {
    RandomStream draw = stream_for(seed_, proto::Rpc::kGetCoachActions, state);
    fill(*actions.add_actions(), draw, 0);
  }
  void decide_as_trainer(const protos::State& state,
                         protos::TrainerActions& actions) const override {
    RandomStream draw = stream_for(seed_, proto::Rpc::kGetTrainerActions, state);
    fill(*actions.add_actions(), draw, 0);
  }

 private:
  std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<Behavior> make_random_behavior(std::uint64_t seed) {
  return std::make_unique<RandomBehavior>(seed);
}

}  // namespace cls::mock_server
