// Pools with buffers, through the C interface.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "training/c_api/cls_training.h"
#include "training/pool/pool.h"

namespace cls::tests {

/// A setup of a configuration; throws std::runtime_error with the error text.
std::shared_ptr<const training::Setup> setup_of(const std::string& config);

/// A pool and all its arrays. Closes it at the end.
class BoundPool {
 public:
  /// Throws std::runtime_error, which fails the test, if the configuration is refused.
  explicit BoundPool(const std::string& config);
  /// Resets it with the seeds from `first` on; throws as above.
  BoundPool(const std::string& config, std::uint64_t first);
  ~BoundPool();
  BoundPool(const BoundPool&) = delete;
  BoundPool& operator=(const BoundPool&) = delete;

  /// Resets all worlds with the seeds first, first + 1, ...
  int reset(std::uint64_t first);
  int step() { return cls_training_step(handle); }
  /// Draws actions of all agents; also seeds of automatic resets.
  void draw_actions(soccer::RandomStream& random);
  /// Plays steps with actions of `random` and expects that they succeed; returns the outputs().
  std::string play(soccer::RandomStream& random, int steps);
  /// The physical state of a world.
  cls_training_world view(std::size_t world = 0) const;
  /// Everything that the pool writes, as bytes.
  std::string outputs() const;

  std::uint64_t handle = 0;
  std::size_t worlds = 0;
  std::size_t agents = 0;
  std::size_t features = 0;
  std::size_t ids = 0;
  std::size_t width = 0;  ///< of a row of ids
  std::size_t states = 0;
  training::Columns value_columns;

#define CLS_TRAINING_ARRAY(type, name, count, needed) std::vector<std::remove_const_t<type>> name;
#include "training/pool/arrays.inc"
  cls_training_buffers buffers = {};
};

}  // namespace cls::tests
