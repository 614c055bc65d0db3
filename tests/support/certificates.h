// Certificates of the tests' own, made when they are needed.
#pragma once

#include <memory>
#include <string>

namespace cls::tests {

/// A certificate and its key as PEM text.
struct Identity {
  std::string certificate;
  std::string key;
};

enum class Validity { kNow, kOver, kNotYet };

/// Signs certificates for others.
class Authority {
 public:
  Authority();
  ~Authority();
  Authority(const Authority&) = delete;
  Authority& operator=(const Authority&) = delete;

  /// Its own certificate, for those who trust it.
  std::string certificate() const;
  /// For a server or client that bears this name: "localhost", or an address such as "127.0.0.1".
  Identity issue(const std::string& name, Validity validity = Validity::kNow) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cls::tests
