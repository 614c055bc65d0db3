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
  states = setup.state_columns.size();
  value_columns = setup.value_columns;
  if (cls_training_create(config.c_str(), &handle) != CLS_TRAINING_OK) {
    throw std::runtime_error(cls_training_error());
  }
  const std::size_t rows = worlds * agents;
  buffers.struct_size = sizeof buffers;
  buffers.action_ids = sized(action_ids, ids > 0 ? rows : 0);
  buffers.action_values = sized(action_values, rows * value_columns.size());
  buffers.next_seeds = sized(next_seeds, worlds);
  buffers.observations = sized(observations, rows * features);
  buffers.rewards = sized(rewards, rows);
  buffers.terminated = sized(terminated, worlds);
  buffers.truncated = sized(truncated, worlds);
  buffers.status = sized(status, worlds);
  buffers.alive = sized(alive, rows);
  buffers.action_masks = sized(action_masks, rows * ids);
  buffers.state = sized(state, worlds * states);
  buffers.reward_terms = sized(reward_terms, worlds * training::kRewardTerms);
  buffers.final_observations = sized(final_observations, rows * features);
  buffers.final_state = sized(final_state, worlds * states);
  buffers.was_reset = sized(was_reset, worlds);
  buffers.cycles = sized(cycles, worlds);
  buffers.score = sized(score, 2 * worlds);
  buffers.illegal = sized(illegal, rows);
  buffers.seeds = sized(seeds, worlds);
  buffers.opponent = sized(opponent, worlds);
  if (cls_training_bind(handle, &buffers) != CLS_TRAINING_OK) {
    throw std::runtime_error(cls_training_error());
  }
}

BoundPool::~BoundPool() { cls_training_close(handle); }

int BoundPool::reset(std::uint64_t first) {
  std::vector<std::uint64_t> all(worlds);
  for (std::size_t i = 0; i < worlds; ++i) all[i] = first + i;
  return cls_training_reset(handle, nullptr, all.data(), worlds);
}

void BoundPool::draw_actions(soccer::RandomStream& random) {
  for (std::int32_t& id : action_ids) id = random.integer(static_cast<int>(ids));
  for (std::size_t i = 0; i < action_values.size(); ++i) {
    const training::Column& column = value_columns[i % value_columns.size()];
    action_values[i] = static_cast<float>(
        random.uniform(static_cast<double>(column.low), static_cast<double>(column.high)));
  }
  for (std::uint64_t& seed : next_seeds) seed = random.next();
}

std::string BoundPool::outputs() const {
  std::string out;
  append(out, observations);
  append(out, rewards);
  append(out, terminated);
  append(out, truncated);
  append(out, status);
  append(out, alive);
  append(out, action_masks);
  append(out, state);
  append(out, reward_terms);
  append(out, final_observations);
  append(out, was_reset);
  append(out, cycles);
  append(out, score);
  append(out, illegal);
  append(out, seeds);
  append(out, opponent);
  return out;
}

}  // namespace cls::tests
