"""Starts a team in the page: the package cls_playmaker as far as decisions need it, and decide.py."""
from __future__ import annotations

import importlib
import json
import sys
import types
from typing import Any, Optional

import cls_messages

_package: Any = types.ModuleType("cls_playmaker")
_package.proto = types.ModuleType("cls_playmaker.proto")
sys.modules["cls_playmaker"] = _package
sys.modules["cls_playmaker.proto"] = _package.proto
_functions = {"GetPlayerActions": "decide", "GetCoachActions": "decide_as_coach"}
_team: Any = None


def load(schema: str) -> None:
    """Imports the team. `schema` is the description of the messages as JSON."""
    global _team
    cls_messages.add_messages(json.loads(schema), _package.proto)
    _team = importlib.import_module("decide")
    if not callable(getattr(_team, "decide", None)):
        raise TypeError("decide.py has no function decide")


def answer(rpc: str, state: Any) -> Optional[bytes]:
    """The bytes of the reply to a State, a buffer of the page; None: the team has no such function."""
    function = getattr(_team, _functions[rpc], None)
    if function is None:
        return None
    reply = function(_package.proto.State.FromString(memoryview(state.to_bytes())))
    if not isinstance(reply, cls_messages.Message):
        raise TypeError(f"{_functions[rpc]} returned {type(reply).__name__}, not a message")
    return reply.SerializeToString()
