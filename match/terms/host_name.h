// Hosts in addresses that users write.
#pragma once

#include <string>
#include <string_view>

namespace cls::match {

/// Why `host` cannot stand before a port: it has a scheme, a space, or an IPv6 address without
/// brackets. Empty: it can; whether the host exists is another question.
std::string host_problem(std::string_view host);

}  // namespace cls::match
