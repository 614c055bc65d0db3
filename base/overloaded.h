// One function object of several: for std::visit, a case for each alternative.
#pragma once

namespace cls::base {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace cls::base
