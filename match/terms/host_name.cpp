// Checks of the characters.
#include "match/terms/host_name.h"

#include <algorithm>

#include "base/system/socket_address.h"

namespace cls::match {

std::string host_problem(std::string_view host) {
  if (host.empty()) return "no host before the port";
  if (host.find("://") != std::string_view::npos) {
    return "an address has no scheme; write HOST:PORT";
  }

  if (host.front() == '[' || host.back() == ']') {
    const std::string inside = base::strip_brackets(std::string(host));
    const std::string address = inside.substr(0, inside.find('%'));  // a zone, as in fe80::1%eth0
    const bool ipv6 = inside.size() + 2 == host.size() && address.find(':') != std::string::npos &&
                      base::parse_ip_address(address, 1);
    return ipv6 ? "" : "only an IPv6 address stands in brackets";
  }
  if (host.find(':') != std::string_view::npos) {
    return "an IPv6 address stands in brackets, as in [::1]:50051";
  }

  constexpr std::string_view kNever = "/\\@?#\"'<>,;()[]{}|";
  const auto found = std::ranges::find_if(host, [kNever](char c) {
    return static_cast<unsigned char>(c) <= ' ' || c == '\x7f' || kNever.find(c) != kNever.npos;
  });
  if (found == host.end()) return "";
  if (static_cast<unsigned char>(*found) <= ' ') return "there is whitespace in the host";
  return std::string("no host name has the character '") + *found + "'";
}

}  // namespace cls::match
