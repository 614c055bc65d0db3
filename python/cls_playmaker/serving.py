"""Serves a Playmaker: port, logging of exceptions, graceful stop."""
from __future__ import annotations

import argparse
import logging
import os
import signal
import socket
import sys
import threading
import traceback
from concurrent import futures
from typing import Any, Callable, Optional, Set, Tuple

import grpc

from cls_playmaker import proto

_log = logging.getLogger("cls_playmaker")
_WORKERS = 32  # two teams with coaches and a trainer have 25 agents
_GRACE = 1.0   # seconds for calls in flight after SIGTERM or SIGINT


class Playmaker(proto.GameServicer):
    """A Playmaker that accepts every agent and all parameters; a subclass decides.

    Override GetPlayerActions, which returns proto.PlayerActions. A subclass may also override
    GetCoachActions, GetTrainerActions and GetBestPlannerAction, which are UNIMPLEMENTED here: the
    team then plays without coach, trainer, or with the planner's own choice. Calls for different
    agents run in parallel threads: guard state that they share.
    """

    def Register(self, request: proto.RegisterRequest, context: Any) -> proto.RegisterResponse:
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


def _caller(request: Any) -> str:
    """"player 9 of RED at cycle 120", as far as the request says it."""
    agent = getattr(request, "register_response", request)
    role = proto.AgentType.Name(agent.agent_type)[:-1].lower()
    number = f" {agent.uniform_number}" if role == "player" else ""
    state = getattr(request, "state", request)
    cycle = f" at cycle {state.world_model.cycle}" if hasattr(state, "world_model") else ""
    return f"{role}{number} of {agent.team_name}{cycle}"


def _place(error: BaseException) -> str:
    """"team.py:12": the innermost line outside installed packages."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if os.sep + "site-packages" + os.sep not in frame.filename
           and frame.filename != __file__]
    frame = (own or frames)[-1]
    return f"{os.path.basename(frame.filename)}:{frame.lineno}"


class _ReportErrors(grpc.ServerInterceptor):
    """Logs exceptions of the Playmaker's methods and sends their text as status of the RPC."""

    def __init__(self) -> None:
        self._seen: Set[Tuple[str, str, str]] = set()

    def intercept_service(self, continuation: Callable[[Any], Any], details: Any) -> Any:
        handler = continuation(details)
        if handler is None or handler.unary_unary is None:
            return handler
        rpc = details.method.rpartition("/")[2]
        wanted = proto.DESCRIPTOR.services_by_name["Game"].methods_by_name[rpc].output_type.name

        def call(request: Any, context: Any) -> Any:
            try:
                reply = handler.unary_unary(request, context)
                if type(reply).__name__ != wanted:
                    raise TypeError(
                        f"{rpc} returned {type(reply).__name__}, must return proto.{wanted}")
                return reply
            except Exception as error:  # pylint: disable=broad-except
                if context.code() is not None:  # chosen by the method, UNIMPLEMENTED by default
                    context.abort(context.code(), _text(context.details()))
                self._log(rpc, request, error)
                return context.abort(grpc.StatusCode.UNKNOWN,
                                     f"{type(error).__name__}: {error} ({_place(error)})")

        return grpc.unary_unary_rpc_method_handler(call, handler.request_deserializer,
                                                   handler.response_serializer)

    def _log(self, rpc: str, request: Any, error: Exception) -> None:
        """The first exception of each line with its traceback, later ones in one line."""
        key = (rpc, type(error).__name__, _place(error))
        first = key not in self._seen
        self._seen.add(key)
        _log.error("%s: %s: %s: %s (%s)", _caller(request), rpc, type(error).__name__, error,
                   key[2], exc_info=error if first else None)


def _text(details: Any) -> str:
    return details.decode(errors="replace") if isinstance(details, bytes) else details or ""


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
    # Without so_reuseport = 0 a second server on the port would take half of the calls.
    server = grpc.server(futures.ThreadPoolExecutor(max_workers=_WORKERS),
                         interceptors=[_ReportErrors()], options=[("grpc.so_reuseport", 0)])
    proto.add_GameServicer_to_server(playmaker, server)
    _try_to_listen(host, port)
    bound = server.add_insecure_port(f"{host}:{port}")
    server.start()
    return server, bound


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
    stop = threading.Event()
    previous = {number: signal.signal(number, lambda *_: stop.set())
                for number in (signal.SIGTERM, signal.SIGINT)}
    try:
        server, bound = start(playmaker, port, host)
    except OSError as error:
        sys.exit(error.strerror)
    print(f"listening on {host}:{bound}", flush=True)
    stop.wait()
    server.stop(_GRACE).wait()
    for number, handler in previous.items():
        signal.signal(number, handler)
