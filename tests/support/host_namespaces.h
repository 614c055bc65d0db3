// Whether this host lets its users make namespaces, as util-linux finds out.
#pragma once

#include "process/confinement.h"
#include "process/landlock.h"
#include "tests/support/command.h"

namespace cls::tests {

inline bool host_has_namespaces() {
  static const bool has = process::landlock_version() > 0 && process::can_confine() &&
                          run({"unshare", "--user", "--map-root-user", "--net", "--ipc", "--uts",
                               "--pid", "--fork", "--mount-proc", "true"})
                                  .exit_code == 0;
  return has;
}

}  // namespace cls::tests
