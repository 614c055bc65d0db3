// Python for tests of Playmakers in Python.
#pragma once

#include <string>

namespace cls::tests {

/// A Python that can import grpc and google.protobuf: the system's, or the first one on PATH.
/// Empty: there is none; then `GTEST_SKIP() << kNoPython`.
std::string python_with_grpc();

inline constexpr const char* kNoPython = "no Python with grpc: install python3-grpcio";

}  // namespace cls::tests
