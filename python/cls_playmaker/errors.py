"""Exceptions of a Playmaker's methods: logged here, and the status of the call for the match."""
from __future__ import annotations

import ast
import inspect
import logging
import os
import textwrap
import traceback
from typing import Any, Callable, List, Optional, Set, Tuple

import grpc

from cls_playmaker import proto
from cls_playmaker.stalls import STALLS, own_frames

_log = logging.getLogger("cls_playmaker")
_REPLIES = {method.name: "proto." + method.output_type.name
            for method in proto.DESCRIPTOR.services_by_name["Game"].methods}


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
                        lambda: method(request, context), method)

    def run(self, name: str, wanted: str, caller: Callable[[], str], context: Any,
            method: Callable[[], Any], source: Any = None) -> Any:
        """What `method` returns, which must be a `wanted`; `name` and `caller` are for the log.
        A wrong value is reported with the line that defines what returned it: `source`, or `method`,
        or the function whose value that returns."""
        try:
            with STALLS.watch(name, caller):
                reply = method()
            if not _chosen(context) and not _is_a(reply, wanted):
                raise TypeError(f"{name} returned {type(reply).__name__}, must return {wanted}")
        except (Exception, SystemExit) as error:  # gRPC's thread would end without a reply
            if not _chosen(context):
                place = _place(error, source or method)
                self._log(name, caller(), error, place)
                text = f"{type(error).__name__}: {error} ({place})"
                raise Failure(grpc.StatusCode.UNKNOWN, text) from error
        if _chosen(context):  # by the method, UNIMPLEMENTED by default
            raise Failure(context.code(), _text(context.details()))
        return reply

    def _log(self, name: str, caller: str, error: BaseException, place: str) -> None:
        """The first exception of each line with its traceback, later ones in one line."""
        key = (name, type(error).__name__, place)
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


def _place(error: BaseException, source: Any) -> str:
    """"team.py:12": the innermost line outside installed packages, or the definition of `source`."""
    frames = traceback.extract_tb(error.__traceback__)
    own = own_frames(frames)
    code = getattr(source if own else _maker(source), "__code__", None)
    file, line = frames[-1].filename, frames[-1].lineno
    if own:
        file, line = own[-1].filename, own[-1].lineno
    elif code is not None:
        file, line = code.co_filename, code.co_firstlineno
    return f"{os.path.basename(file)}:{line}"


def _maker(function: Any, depth: int = 3) -> Any:
    """Where the value that `function` returns is made: `return decide.decide(state)` leads to
    decide(). The function itself where its source does not say."""
    found = _returned_functions(function) if depth else []
    return _maker(found[0], depth - 1) if len(found) == 1 else function


def _returned_functions(function: Any) -> List[Any]:
    """Functions of the team whose value `function` returns; empty if it also returns others."""
    try:
        tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    except (OSError, TypeError, SyntaxError):
        return []
    values = [node.value for node in ast.walk(tree) if isinstance(node, ast.Return)]
    if not all(isinstance(value, ast.Call) for value in values):
        return []
    called = [_resolved(value.func, function) for value in values if isinstance(value, ast.Call)]
    return [one for one in called if inspect.isfunction(one)]


def _resolved(name: ast.expr, function: Any) -> Optional[Any]:
    """What `name` or `module.name` means in a function; None: not known."""
    names = getattr(inspect.unwrap(function), "__globals__", {})
    if isinstance(name, ast.Name):
        return names.get(name.id)
    if isinstance(name, ast.Attribute) and isinstance(name.value, ast.Name):
        return getattr(names.get(name.value.id), name.attr, None)
    return None


def _text(details: Any) -> str:
    return details.decode(errors="replace") if isinstance(details, bytes) else details or ""
