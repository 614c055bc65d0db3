// The feature sets and action sets of training, for Playmakers that serve trained policies.
#pragma once

#include <memory>

#include "proxy/playmaker/tensor_codec.h"

namespace cls::match {

/// A codec for one team. Rows show the whole pitch, `time_left` is 1. With 10 teammates and 11
/// opponents the players come by uniform number, as in the task Match; with fewer those who are
/// seen and nearest to the agent, nearest first.
std::shared_ptr<proxy::TensorCodec> make_policy_rows();

}  // namespace cls::match
