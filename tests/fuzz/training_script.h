// Training scripts: any bytes are a valid sequence of calls of the C interface.
#pragma once

#include <string_view>

namespace cls::tests {

/// Calls the C interface of the training engine; aborts if a call fails without an error text, or
/// if what the pool writes is not finite. The first line is the configuration of the pool, which is
/// made smaller if it asks for many worlds. Lines:
///     r SEED         a reset of all worlds
///     a NUMBERS      the actions from now on, repeated until every agent has one
///     s              a step
///     o OPTIONS      options of the task as JSON, for all worlds
///     k              a snapshot; p puts the last one back
///     f              copies the first world into the last one
///     v              looks at the first world
///     b NUMBER       binds buffers of which one has a wrong size
/// Returns the number of steps.
int play_training_script(std::string_view script);

}  // namespace cls::tests
