// Configuration of a pool: JSON in, checked values out.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "training/episode/setup.h"

namespace cls::training {

enum class Autoreset : unsigned char { kDisabled, kNextStep, kSameStep };

/// "full_state" or "world_model"
std::string_view fidelity_name(Fidelity fidelity);

/// "disabled", "next_step" or "same_step"
std::string_view autoreset_name(Autoreset mode);

struct PoolConfig {
  std::shared_ptr<const Setup> setup;
  int num_envs = 1;
  int threads = 1;
  Autoreset autoreset = Autoreset::kDisabled;
  OptionValues options{};
};

/// Parses the keys that training/c_api/cls_training.h describes. The error names the key.
base::Result<PoolConfig> parse_pool_config(const std::string& json);

/// Changes the named options of a task: {"NAME": number, ...}.
base::Result<OptionValues> parse_options(const Task& task, const std::string& json,
                                         OptionValues values);

}  // namespace cls::training
