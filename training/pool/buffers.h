// Arrays of a pool, owned by the caller.
#pragma once

#include <cstdint>

namespace cls::training {

/// Shapes and meanings: training/c_api/cls_training.h. Null pointers are not filled.
struct Buffers {
  const std::int32_t* action_ids = nullptr;
  const float* action_values = nullptr;
  const std::uint64_t* next_seeds = nullptr;

  float* observations = nullptr;
  float* rewards = nullptr;
  std::uint8_t* terminated = nullptr;
  std::uint8_t* truncated = nullptr;
  std::int32_t* status = nullptr;
  std::uint8_t* alive = nullptr;
  std::uint8_t* action_masks = nullptr;
  float* state = nullptr;
  float* reward_terms = nullptr;
  float* final_observations = nullptr;
  float* final_state = nullptr;
  std::uint8_t* was_reset = nullptr;
  std::int32_t* cycles = nullptr;
  std::int32_t* score = nullptr;
  std::int32_t* illegal = nullptr;
  std::uint64_t* seeds = nullptr;
  std::int32_t* opponent = nullptr;
};

}  // namespace cls::training
