"""Serves a Playmaker: port, services, graceful stop."""
from __future__ import annotations

import argparse
import contextlib
import errno
import logging
import os
import signal
import socket
import sys
from concurrent import futures
from typing import Any, Callable, Dict, Iterator, Optional, Tuple

import grpc

from cls_playmaker import proto
from cls_playmaker.errors import Errors, Failure
from cls_playmaker.rows import RowForm, TeamActions, TeamRows
from cls_playmaker.team import TeamServicer
from cls_playmaker.team_playmaker_pb2_grpc import add_TeamPlaymakerServicer_to_server

_WORKERS = 32  # two teams with coaches and a trainer have 25 agents
_WINDOW = 1 << 20  # bytes of a call under way: the States of a team exceed the usual 64 KB
_MAX_PORT = 65535
_GRACE = 1.0   # seconds for calls in flight after SIGTERM or SIGINT


class Playmaker(proto.GameServicer):
    """A Playmaker that accepts every agent and all parameters; a subclass decides.

    Override GetPlayerActions, which returns proto.PlayerActions, or GetTeamActions, which decides
    for all players in one call. A subclass may also override GetCoachActions, GetTrainerActions and
    GetBestPlannerAction, which are UNIMPLEMENTED here: the team then plays without coach, trainer,
    or with the planner's own choice. Calls run in several threads, those of a team in turn or in
    parallel (docs/wire.md): guard state that they share.

    With `lean_states = True` a match that asks for the whole team may send States whose
    `our_players_dict` and `their_players_dict` lack the players of `teammates` and `opponents`:
    less to parse. complete_state() adds them.

    With a `row_form` a match that asks for the whole team sends numbers instead of States, and
    GetTeamRows decides: for trained policies.
    """

    lean_states = False
    row_form: Optional[RowForm] = None

    def GetTeamRows(self, rows: TeamRows) -> TeamActions:
        """The actions of the players of `rows`; needed with a `row_form`."""
        raise NotImplementedError("GetTeamRows")

    def refuses(self, rated: bool) -> str:
        """Why this Playmaker plays no such match; empty: it does. `rated`: the match belongs to a
        tournament or comparison."""
        return ""

    def GetTeamActions(self, states: Dict[int, proto.State],
                       context: Any) -> Dict[int, proto.PlayerActions]:
        """Actions by uniform number; GetPlayerActions decides for players that it leaves out.

        `states` has the players that are due, one alone where a match asks each agent alone.
        """
        return {}

    def GetPlayerActions(self, request: proto.State, context: Any) -> proto.PlayerActions:
        unum = request.register_response.uniform_number
        actions = self.GetTeamActions({unum: request}, context)
        return actions[unum] if unum in actions else super().GetPlayerActions(request, context)

    def Register(self, request: proto.RegisterRequest, context: Any) -> proto.RegisterResponse:
        if self.row_form is not None and isinstance(context, grpc.ServicerContext):
            context.abort(grpc.StatusCode.FAILED_PRECONDITION,
                          "needs the calls of a team: play without --batch never, on one port")
        return proto.RegisterResponse(
            client_id=request.uniform_number, agent_type=request.agent_type,
            team_name=request.team_name, uniform_number=request.uniform_number,
            rpc_server_language_type=proto.PYThON)

    def SendServerParams(self, request: Any, context: Any) -> proto.Empty:
        return proto.Empty()

    def SendPlayerParams(self, request: Any, context: Any) -> proto.Empty:
        return proto.Empty()

    def SendPlayerType(self, request: Any, context: Any) -> proto.Empty:
        return proto.Empty()

    def SendInitMessage(self, request: Any, context: Any) -> proto.Empty:
        return proto.Empty()

    def SendByeCommand(self, request: Any, context: Any) -> proto.Empty:
        return proto.Empty()


class _ReportErrors(grpc.ServerInterceptor):
    """Sends exceptions of the Playmaker's methods as status of the RPC."""

    def __init__(self, errors: Errors) -> None:
        self._errors = errors

    def intercept_service(self, continuation: Callable[[Any], Any], details: Any) -> Any:
        handler = continuation(details)
        service, _, rpc = details.method.rpartition("/")
        if handler is None or handler.unary_unary is None or service != "/protos.Game":
            return handler

        def call(request: Any, context: Any) -> Any:
            try:
                return self._errors.call(rpc, handler.unary_unary, request, context)
            except Failure as failure:
                return context.abort(failure.code, failure.text)

        return grpc.unary_unary_rpc_method_handler(call, handler.request_deserializer,
                                                   handler.response_serializer)


def _try_to_listen(host: str, port: int) -> None:
    """Raises OSError with the reason, which grpc does not give."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        socket.create_server((host.strip("[]"), port), family=family).close()
    except OSError as error:
        reason = os.strerror(error.errno) if error.errno and error.errno > 0 else str(error)
        raise OSError(error.errno, f"cannot listen on {host}:{port}: {reason}") from error


def start(playmaker: proto.GameServicer, port: int = 0,
          host: str = "127.0.0.1") -> Tuple[grpc.Server, int]:
    """Starts a server and returns it with its port; port 0 selects a free one.

    The caller stops it: `server.stop(grace_seconds)`. Raises OSError if it cannot listen.
    """
    if not 0 <= port <= _MAX_PORT:
        raise OSError(errno.EINVAL, f"port {port} is not within 0 to {_MAX_PORT}")
    errors = Errors()
    # Without so_reuseport = 0 a second server on the port would take half of the calls.
    options = [("grpc.so_reuseport", 0), ("grpc.http2.lookahead_bytes", _WINDOW)]
    server = grpc.server(futures.ThreadPoolExecutor(max_workers=_WORKERS),
                         interceptors=[_ReportErrors(errors)], options=options)
    proto.add_GameServicer_to_server(playmaker, server)
    add_TeamPlaymakerServicer_to_server(TeamServicer(playmaker, errors), server)
    _try_to_listen(host, port)
    bound = server.add_insecure_port(f"{host}:{port}")
    server.start()
    return server, bound


@contextlib.contextmanager
def _stop_signals() -> Iterator[Callable[[], None]]:
    """Catches SIGTERM and SIGINT; yields what waits for the first of them.

    Their numbers come through a socket. A handler in Python would not do: it runs between two
    bytecodes of the main thread, so it is too late for a wait that is just about to begin.
    """
    receiver, sender = socket.socketpair()
    with receiver, sender:
        sender.setblocking(False)
        numbers = (signal.SIGTERM, signal.SIGINT)
        previous_descriptor = signal.set_wakeup_fd(sender.fileno(), warn_on_full_buffer=False)
        previous = {number: signal.signal(number, lambda *_: None) for number in numbers}

        def wait() -> None:
            while receiver.recv(1)[0] not in numbers:
                pass

        try:
            yield wait
        finally:
            for number, handler in previous.items():
                signal.signal(number, handler)
            signal.set_wakeup_fd(previous_descriptor)


def _port_of_command_line() -> int:
    parser = argparse.ArgumentParser(description="A Playmaker: serves a team of cls.")
    parser.add_argument("--port", type=int, default=50051,
                        help="listening port; 0 selects a free one (default: 50051)")
    return parser.parse_args().port


def serve(playmaker: proto.GameServicer, port: Optional[int] = None,
          host: str = "127.0.0.1") -> None:
    """Serves until SIGTERM or SIGINT; call it from the main thread.

    Without `port` it reads `--port N` from the command line (default: 50051; 0 selects a free port).
    Prints "listening on HOST:PORT" to stdout. Logs to stderr, unless the program has configured
    `logging` before: an exception with RPC, player, cycle and traceback. Exits with status 1 if it
    cannot listen.
    """
    logging.basicConfig(format="%(asctime)s %(levelname)s %(message)s", level=logging.INFO)
    port = _port_of_command_line() if port is None else port
    with _stop_signals() as wait_for_stop:
        try:
            server, bound = start(playmaker, port, host)
        except OSError as error:
            sys.exit(error.strerror)
        print(f"listening on {host}:{bound}", flush=True)
        wait_for_stop()
        server.stop(_GRACE).wait()
