"""Ids of environments: "cls/HalfFieldOffense-v0", "cls/HFO-2v1-v0"; without "cls/" too."""
from __future__ import annotations

import difflib
import re
from typing import Any, Dict, List, Tuple

from cls_gym._config import ConfigError
from cls_gym._engine import catalog

_SHORT = re.compile(r"HFO-(\d+)v(\d+)$")
HFO_SIZES = [(1, 0), (1, 1), (2, 1), (2, 2), (3, 2), (3, 3), (4, 3), (4, 4), (4, 5), (5, 5)]


def resolve(id: str) -> Tuple[str, Dict[str, Any]]:
    """The engine's task and the settings that an id stands for."""
    if not isinstance(id, str):
        raise ConfigError(f"task: a name such as 'cls/HFO-1v0-v0', not {id!r:.60}")
    name, _, version = id.rpartition("-v")
    if not version.isdigit():
        name, version = id, ""
    name = name[4:] if name.startswith("cls/") else name
    settings: Dict[str, Any] = {}
    short = _SHORT.match(name)
    if short:
        name = "HalfFieldOffense"
        settings = {"offense": int(short[1]), "defense": int(short[2])}
    versions = {task["id"]: task["version"] for task in catalog()["tasks"]}
    if name not in versions:
        close = difflib.get_close_matches(f"cls/{name}-v0", ids(), 1, 0.5)
        hint = f"; did you mean {close[0]}?" if close else f"; tasks: {', '.join(ids())}"
        raise ConfigError(f"task: unknown {id!r}{hint}")
    if version and int(version) != versions[name]:
        raise ConfigError(f"task: {id}: this cls has cls/{name}-v{versions[name]} only")
    return name, settings


def ids() -> List[str]:
    """All ids, with version."""
    versions = {task["id"]: task["version"] for task in catalog()["tasks"]}
    short = [f"cls/HFO-{offense}v{defense}-v{versions['HalfFieldOffense']}"
             for offense, defense in HFO_SIZES if "HalfFieldOffense" in versions]
    return [f"cls/{name}-v{version}" for name, version in versions.items()] + short
