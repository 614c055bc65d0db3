// Sizes and binds the arrays of a pool.
#include "tests/training/stage.h"

#include <stdexcept>

namespace cls::tests {
namespace {

template <typename T>
cls_training_buffer sized(std::vector<T>& vector, std::size_t count) {
  vector.assign(count, T{});
  return {vector.data(), count};
}

// Fuzzers link this file, too, so it does without GoogleTest, which reports what is thrown.
void expect_ok(int status) {
  if (status != CLS_TRAINING_OK) throw std::runtime_error(cls_training_error());
}

template <typename T>
void append(std::string& out, const std::vector<T>& vector) {
  out.append(reinterpret_cast<const char*>(vector.data()), vector.size() * sizeof(T));
}

}  // namespace

std::shared_ptr<const training::Setup> setup_of(const std::string& config) {
  auto parsed = training::parse_pool_config(config);
  if (!parsed) throw std::runtime_error(parsed.error().message);
  return parsed->setup;
}

BoundPool::BoundPool(const std::string& config) {
  const auto parsed = training::parse_pool_config(config);
  if (!parsed) throw std::runtime_error(parsed.error().message);
  const training::Setup& setup = *parsed->setup;
  worlds = static_cast<std::size_t>(parsed->num_envs);
  agents = setup.agent_count();
  features = setup.feature_count();
  ids = setup.id_count();
  width = setup.id_width();
  states = setup.state_columns.size();
  value_columns = setup.value_columns;

  expect_ok(cls_training_create(config.c_str(), &handle));

  const std::size_t rows = worlds * agents;
  const std::size_t values = value_columns.size();
  const std::size_t experts = setup.expert ? rows : 0;
  constexpr std::size_t terms = training::kRewardTerms;
  buffers.struct_size = sizeof buffers;
#define CLS_TRAINING_ARRAY(type, name, count, needed) buffers.name = sized(name, count);
#include "training/pool/arrays.inc"

  expect_ok(cls_training_bind(handle, &buffers));
}

BoundPool::BoundPool(const std::string& config, std::uint64_t first) : BoundPool(config) {
  expect_ok(reset(first));
}

BoundPool::~BoundPool() { cls_training_close(handle); }

int BoundPool::reset(std::uint64_t first) {
  std::vector<std::uint64_t> all(worlds);
  for (std::size_t i = 0; i < worlds; ++i) all[i] = first + i;
  return cls_training_reset(handle, nullptr, all.data(), worlds);
}

void BoundPool::draw_actions(soccer::RandomStream& random) {
  // Senses stay as those of agents in matches.
  for (std::size_t i = 0; i < action_ids.size(); i += width) {
    action_ids[i] = random.integer(static_cast<int>(ids));
  }
  for (std::size_t i = 0; i < action_values.size(); ++i) {
    const training::Column& column = value_columns[i % value_columns.size()];
    action_values[i] = static_cast<float>(
        random.uniform(static_cast<double>(column.low), static_cast<double>(column.high)));
  }
  for (std::uint64_t& seed : next_seeds) seed = random.next();
}

std::string BoundPool::play(soccer::RandomStream& random, int steps) {
  std::string bytes;
  for (int i = 0; i < steps; ++i) {
    draw_actions(random);
    expect_ok(step());
    bytes += outputs();
  }
  return bytes;
}

cls_training_world BoundPool::view(std::size_t world) const {
  cls_training_world out = {};
  out.struct_size = sizeof out;
  expect_ok(cls_training_view(handle, world, &out));
  return out;
}

std::string BoundPool::outputs() const {
  std::string out;
#define CLS_TRAINING_ARRAY(type, name, count, needed) \
  if (!std::is_const_v<type>) append(out, name);
#include "training/pool/arrays.inc"
  return out;
}

}  // namespace cls::tests
