// Python for tests of Playmakers in Python.
#include "tests/support/python.h"

#include "tests/support/command.h"

namespace cls::tests {

std::string python_with_grpc() {
  for (const char* python : {"/usr/bin/python3", "python3"}) {
    if (run({python, "-c", "import grpc, google.protobuf"}).exit_code == 0) return python;
  }
  return "";
}

}  // namespace cls::tests
