"""What a Playmaker on cls_playmaker reports and how it stops."""
import signal
import subprocess
import sys
import threading
import unittest

import grpc
from cls_playmaker import Playmaker, proto, start

# Player 7 waits with Python's lock free, or in a library that holds it.
HANGING = """
import ctypes, time
from cls_playmaker import Playmaker, proto, serve
class Team(Playmaker):
    def GetPlayerActions(self, state, context):
        if state.register_response.uniform_number == 7:
            HANG
        return proto.PlayerActions()
serve(Team(), 0)
"""

PROGRAM = "from cls_playmaker import Playmaker, serve; serve(Playmaker())"


class Team(Playmaker):
    """Player 1 acts; the others make mistakes."""

    def GetPlayerActions(self, state, context):
        unum = state.register_response.uniform_number
        if unum == 2:
            raise ValueError("my policy hurts")
        if unum == 3:
            return None
        if unum == 4:
            return {"dash": 100}
        if unum == 5:
            sys.exit("enough")
        return proto.PlayerActions(actions=[proto.PlayerAction(dash=proto.Dash(power=100))])


def state(unum, cycle=120):
    return proto.State(
        register_response=proto.RegisterResponse(team_name="RED", uniform_number=unum),
        world_model=proto.WorldModel(cycle=cycle))


def decide(_):
    return [1]  # must be proto.PlayerActions


class Delegating(Playmaker):
    def GetPlayerActions(self, state, context):
        return decide(state)


class Serving(unittest.TestCase):
    def setUp(self):
        self.server, self.port = start(Team())
        self.channel = grpc.insecure_channel(f"127.0.0.1:{self.port}")
        self.stub = proto.GameStub(self.channel)

    def tearDown(self):
        self.channel.close()
        self.server.stop(0).wait()

    def fail_of(self, rpc, request):
        with self.assertRaises(grpc.RpcError) as raised:
            rpc(request, timeout=10)
        return raised.exception

    def test_accepts_agents_and_replies(self):
        registered = self.stub.Register(
            proto.RegisterRequest(team_name="RED", uniform_number=7), timeout=10)
        self.assertEqual((registered.client_id, registered.team_name), (7, "RED"))
        self.stub.SendServerParams(proto.ServerParam(), timeout=10)
        self.assertEqual(self.stub.GetPlayerActions(state(1), timeout=10).actions[0].dash.power, 100)

    def test_an_exit_is_an_exception_of_the_player(self):
        with self.assertLogs("cls_playmaker") as logs:
            error = self.fail_of(self.stub.GetPlayerActions, state(5))
        self.assertRegex(error.details(), r"^SystemExit: enough \(serving_test.py:\d+\)$")
        self.assertIn("player 5 of RED at cycle 120", logs.output[0])

    def test_logs_an_exception_with_player_cycle_and_traceback(self):
        with self.assertLogs("cls_playmaker") as logs:
            error = self.fail_of(self.stub.GetPlayerActions, state(2))
        self.assertEqual(error.code(), grpc.StatusCode.UNKNOWN)
        self.assertRegex(error.details(),
                         r"^ValueError: my policy hurts \(serving_test.py:\d+\)$")
        self.assertIn("player 2 of RED at cycle 120: GetPlayerActions: ValueError", logs.output[0])
        self.assertIn("Traceback", logs.output[0])
        self.assertIn('raise ValueError("my policy hurts")', logs.output[0])

    def test_logs_one_traceback_for_each_line_that_fails(self):
        with self.assertLogs("cls_playmaker") as logs:
            for cycle in range(3):
                self.fail_of(self.stub.GetPlayerActions, state(2, cycle))
        self.assertEqual(["Traceback" in line for line in logs.output], [True, False, False])
        self.assertIn("at cycle 2:", logs.output[2])

    def test_names_a_wrong_return_value(self):
        with self.assertLogs("cls_playmaker"):
            for unum, wrong in ((3, "NoneType"), (4, "dict")):
                error = self.fail_of(self.stub.GetPlayerActions, state(unum))
                place = f"serving_test.py:{Team.GetPlayerActions.__code__.co_firstlineno}"
                self.assertEqual(error.details(),
                                 f"TypeError: GetPlayerActions returned {wrong}, "
                                 f"must return proto.PlayerActions ({place})")

    def test_names_the_function_that_made_a_wrong_value(self):
        server, port = start(Delegating())
        with grpc.insecure_channel(f"127.0.0.1:{port}") as channel, self.assertLogs("cls_playmaker"):
            error = self.fail_of(proto.GameStub(channel).GetPlayerActions, state(1))
        server.stop(0).wait()
        line = decide.__code__.co_firstlineno
        self.assertTrue(error.details().endswith(
            f"returned list, must return proto.PlayerActions (serving_test.py:{line})"),
            error.details())

    def test_servers_share_the_thread_that_watches(self):
        self.stub.GetPlayerActions(state(1), timeout=10)
        before = sum(thread.name == "cls stalls" for thread in threading.enumerate())
        server, port = start(Team())
        with grpc.insecure_channel(f"127.0.0.1:{port}") as channel:
            proto.GameStub(channel).GetPlayerActions(state(1), timeout=10)
        server.stop(0).wait()
        after = sum(thread.name == "cls stalls" for thread in threading.enumerate())
        self.assertEqual((before, after), (1, 1))

    def test_names_player_and_line_of_a_call_that_hangs(self):
        for hang, wanted in (
                ("time.sleep(60)",
                 rb"player 7 of RED at cycle 120: GetPlayerActions has not returned for 3 s, "
                 rb"it is at <string>:7\n  <string>:7 in GetPlayerActions: "),
                ("ctypes.PyDLL(None).sleep(60)",
                 rb'(?s)Timeout .*File "<string>", line 7 in GetPlayerActions')):
            with self.subTest(hang=hang):
                child = subprocess.Popen([sys.executable, "-c", HANGING.replace("HANG", hang)],
                                         stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                port = child.stdout.readline().rpartition(b":")[2].strip().decode()
                with grpc.insecure_channel(f"127.0.0.1:{port}") as channel:
                    self.fail_of(lambda request, timeout: proto.GameStub(channel).GetPlayerActions(
                        request, timeout=8), state(7))
                child.kill()
                self.assertRegex(child.communicate()[1], wanted)

    def test_leaves_roles_it_does_not_play_unimplemented_without_a_log_line(self):
        with self.assertNoLogs() if hasattr(self, "assertNoLogs") else self.subTest():
            error = self.fail_of(self.stub.GetCoachActions, state(12))
        self.assertEqual(error.code(), grpc.StatusCode.UNIMPLEMENTED)

    def test_refuses_a_port_that_another_playmaker_has(self):
        with self.assertRaisesRegex(OSError, "cannot listen on 127.0.0.1:.*Address already in use"):
            start(Team(), self.port)


class Program(unittest.TestCase):
    def run_until_listening(self, *arguments):
        program = subprocess.Popen([sys.executable, "-c", PROGRAM, *arguments],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (program.kill(), program.communicate()))
        line = program.stdout.readline()
        self.assertRegex(line, r"^listening on 127.0.0.1:\d+$")
        return program, line.rpartition(":")[2].strip()

    def test_stops_on_sigterm_and_sigint(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            program, _ = self.run_until_listening("--port", "0")
            program.send_signal(number)
            _, errors = program.communicate(timeout=20)
            self.assertEqual((program.returncode, errors), (0, ""))

    def test_says_which_ports_there_are(self):
        for port in ("70000", "-1"):
            done = subprocess.run([sys.executable, "-c", PROGRAM, "--port", port], timeout=60,
                                  stderr=subprocess.PIPE, text=True, check=False)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(f"port {port} is not within 0 to 65535", done.stderr)
            self.assertNotIn("Traceback", done.stderr)

    def test_says_which_port_is_taken(self):
        _, port = self.run_until_listening("--port", "0")
        second = subprocess.run([sys.executable, "-c", PROGRAM, "--port", port], timeout=20,
                                stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(second.returncode, 1)
        self.assertIn(f"cannot listen on 127.0.0.1:{port}: Address already in use", second.stderr)


if __name__ == "__main__":
    unittest.main()
