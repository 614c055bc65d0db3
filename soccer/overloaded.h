// One function object of several: for std::visit, a case for each alternative.
#pragma once

namespace cls::soccer {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace cls::soccer
