// Certificates created by tests.
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

/// A certificate authority (CA).
class Authority {
 public:
  Authority();
  ~Authority();
  Authority(const Authority&) = delete;
  Authority& operator=(const Authority&) = delete;

  /// The CA certificate.
  std::string certificate() const;
  /// A certificate for a server or client name: "localhost", or an address such as "127.0.0.1".
  Identity issue(const std::string& name, Validity validity = Validity::kNow) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cls::tests
