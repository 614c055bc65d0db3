// Exceptions as languages print them.
#include "process/printed_exception.h"

#include <gtest/gtest.h>

namespace cls::process {
namespace {

TEST(PrintedException, IsLastLineOfPythonTraceback) {
  EXPECT_EQ(printed_exception("listening on 127.0.0.1:50051\n"
                              "ERROR:grpc._server:Exception calling application: no ball\n"
                              "Traceback (most recent call last):\n"
                              "  File \"grpc/_server.py\", line 552, in _call_behavior\n"
                              "    response = behavior(argument, context)\n"
                              "  File \"brain.py\", line 3, in GetPlayerActions\n"
                              "    raise ValueError(\"no ball\")\n"
                              "ValueError: no ball\n"
                              "more output\n"),
            "ValueError: no ball");
}

TEST(PrintedException, IsLastOfChainedPythonExceptions) {
  EXPECT_EQ(
      printed_exception("Traceback (most recent call last):\n"
                        "  File \"brain.py\", line 3\n"
                        "KeyError: 7\n"
                        "\n"
                        "During handling of the above exception, another exception occurred:\n"
                        "\n"
                        "Traceback (most recent call last):\n"
                        "  File \"brain.py\", line 5\n"
                        "RuntimeError: no such player\n"),
      "RuntimeError: no such player");
}

TEST(PrintedException, IsPanicOfGoAndRust) {
  EXPECT_EQ(printed_exception("panic: runtime error: index out of range [11] with length 11\n\n"
                              "goroutine 34 [running]:\nmain.decide(...)\n"),
            "panic: runtime error: index out of range [11] with length 11");
  EXPECT_EQ(printed_exception("panic: this is only a word at the start of a line\n"), "");
  EXPECT_EQ(printed_exception("thread 'tokio-runtime-worker' panicked at src/main.rs:12:5:\n"
                              "no ball\nnote: run with `RUST_BACKTRACE=1`\n"),
            "no ball");
}

TEST(PrintedException, IsInnermostCauseOfStackTrace) {
  EXPECT_EQ(printed_exception("SEVERE: Exception while executing runnable\n"
                              "java.lang.IllegalStateException: decision failed\n"
                              "\tat team.Striker.decide(Striker.java:40)\n"
                              "\tat java.base/java.lang.Thread.run(Thread.java:840)\n"
                              "Caused by: java.lang.NullPointerException: ball\n"
                              "\tat team.Striker.pass(Striker.java:12)\n"
                              "\t... 2 more\n"),
            "java.lang.NullPointerException: ball");
  EXPECT_EQ(printed_exception("TypeError: Cannot read properties of undefined (reading 'x')\n"
                              "    at decide (/team/brain.js:12:20)\n"
                              "    at Object.onReceiveHalfClose (server.js:1:2)\n"),
            "TypeError: Cannot read properties of undefined (reading 'x')");
}

TEST(PrintedException, IsMessageOfUncaughtCppException) {
  EXPECT_EQ(printed_exception("terminate called after throwing an instance of 'std::out_of_range'\n"
                              "  what():  vector::_M_range_check\n"),
            "what():  vector::_M_range_check");
}

TEST(PrintedException, IsEmptyWithoutOne) {
  EXPECT_EQ(printed_exception(""), "");
  EXPECT_EQ(printed_exception("player 3 at (10, 2)\n  at ease\ncycle 4: no error\n"), "");
  EXPECT_EQ(printed_exception("Traceback (most recent call last):\n  File \"cut off"), "");
}

TEST(PrintedException, FindsMostRepeatedLine) {
  const RepeatedLine line = most_repeated_line("a\n  ×3\nno ball\n  ×2400\nb\n  ×7\n");
  EXPECT_EQ(line.text, "no ball");
  EXPECT_EQ(line.times, 2400U);
  EXPECT_EQ(most_repeated_line("a\nb\n").times, 0U);
}

}  // namespace
}  // namespace cls::process
