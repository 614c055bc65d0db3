// Configuration of a pool: JSON in, checked values out.
#pragma once

#include <string>

#include "base/result.h"
#include "training/episode/setup.h"

namespace cls::training {

enum class Autoreset : unsigned char { kDisabled, kNextStep, kSameStep };
constexpr auto kAutoresetNames = base::enum_names<Autoreset>("disabled", "next_step", "same_step");

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
