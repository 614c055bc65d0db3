// Sets points in replies.
#pragma once

#include "proto/playmaker.pb.h"
#include "soccer/geometry.h"

namespace cls::tests {

inline void set(protos::RpcVector2D* to, soccer::Vec2 v) {
  to->set_x(static_cast<float>(v.x));
  to->set_y(static_cast<float>(v.y));
}

}  // namespace cls::tests
