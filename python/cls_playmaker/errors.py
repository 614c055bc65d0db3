"""Exceptions of a Playmaker's methods: logged here, and the status of the call for the match."""
from __future__ import annotations

import logging
import os
import traceback
from typing import Any, Callable, Set, Tuple

import grpc

from cls_playmaker import proto

_log = logging.getLogger("cls_playmaker")
_REPLIES = {method.name: "proto." + method.output_type.name
            for method in proto.DESCRIPTOR.services_by_name["Game"].methods}
_OWN = os.path.dirname(__file__) + os.sep


class Failure(Exception):
    """A call that has failed: its status."""

    def __init__(self, code: grpc.StatusCode, text: str) -> None:
        super().__init__(text)
        self.code = code
        self.text = text


class Errors:
    """Calls methods of a Playmaker; logs their exceptions and raises Failure instead."""

    def __init__(self) -> None:
        self._seen: Set[Tuple[str, str, str]] = set()

    def call(self, rpc: str, method: Callable[[Any, Any], Any], request: Any, context: Any) -> Any:
        """The reply of the method for one agent to an RPC of protos.Game."""
        return self.run(rpc, _REPLIES[rpc], lambda: _caller(request), context,
                        lambda: method(request, context))

    def run(self, name: str, wanted: str, caller: Callable[[], str], context: Any,
            method: Callable[[], Any]) -> Any:
        """What `method` returns, which must be a `wanted`; `name` and `caller` are for the log."""
        try:
            reply = method()
            if not _chosen(context) and not _is_a(reply, wanted):
                raise TypeError(f"{name} returned {type(reply).__name__}, must return {wanted}")
        except (Exception, SystemExit) as error:  # gRPC's thread would end without a reply
            if not _chosen(context):
                self._log(name, caller(), error)
                text = f"{type(error).__name__}: {error} ({_place(error)})"
                raise Failure(grpc.StatusCode.UNKNOWN, text) from error
        if _chosen(context):  # by the method, UNIMPLEMENTED by default
            raise Failure(context.code(), _text(context.details()))
        return reply

    def _log(self, name: str, caller: str, error: BaseException) -> None:
        """The first exception of each line with its traceback, later ones in one line."""
        key = (name, type(error).__name__, _place(error))
        first = key not in self._seen
        self._seen.add(key)
        _log.error("%s: %s: %s: %s (%s)", caller, name, type(error).__name__, error, key[2],
                   exc_info=error if first else None)


def _chosen(context: Any) -> bool:
    return context.code() not in (None, grpc.StatusCode.OK)


def _is_a(reply: Any, wanted: str) -> bool:
    name = wanted.rpartition(".")[2]
    kind = type(reply)
    return kind.__name__ == name or any(base.__name__ == name for base in kind.__mro__)


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
           and not frame.filename.startswith(_OWN)]
    frame = (own or frames)[-1]
    return f"{os.path.basename(frame.filename)}:{frame.lineno}"


def _text(details: Any) -> str:
    return details.decode(errors="replace") if isinstance(details, bytes) else details or ""
