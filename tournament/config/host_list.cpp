// Splits the slots from the name of a host.
#include "tournament/config/host_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/text/number_text.h"

namespace cls::tournament {
namespace {

constexpr int kMaxSlots = 4096;

// A leading '-' would be an option of ssh.
bool is_host_name(std::string_view name) {
  constexpr std::string_view kCharacters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789@._:-";
  return !name.empty() && name.front() != '-' && name.find_first_not_of(kCharacters) == name.npos;
}

// "ada@node:2222", but not an IPv6 address.
bool has_port(std::string_view text) {
  const std::size_t colon = text.find(':');
  return colon != text.npos && text.find(':', colon + 1) == text.npos &&
         base::parse_int(text.substr(colon + 1));
}

}  // namespace

base::Result<std::vector<HostSlots>> parse_hosts(const std::vector<std::string>& texts) {
  std::vector<HostSlots> hosts;
  for (const std::string& text : texts) {
    const std::size_t slash = text.find('/');
    const auto slots =
        slash == std::string::npos ? std::optional(1) : base::parse_int(text.substr(0, slash));

    if (has_port(text)) {
      return base::Error{fmt::format(
          "hosts: '{}': ssh takes no port here; write it into remote_shell (\"ssh -p PORT "
          "{{host}}\") or into ~/.ssh/config",
          text)};
    }
    HostSlots host{slash == std::string::npos ? text : text.substr(slash + 1), slots.value_or(0)};
    if (host.slots < 1 || host.slots > kMaxSlots || !is_host_name(host.name)) {
      return base::Error{
          fmt::format("hosts: '{}' must be HOST or MATCHES/HOST, such as node1 or 4/node1", text)};
    }
    if (std::ranges::find(hosts, host.name, &HostSlots::name) != hosts.end()) {
      return base::Error{fmt::format("hosts: {} is listed twice", host.name)};
    }
    hosts.push_back(std::move(host));
  }
  return hosts;
}

}  // namespace cls::tournament
