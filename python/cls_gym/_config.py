"""Keywords of environments: which there are, what may stand in them, errors that name them."""
from __future__ import annotations

import difflib
import math
import re
from typing import Any, Dict, List, Mapping, Sequence, Tuple

import numpy as np


class EngineError(RuntimeError):
    """The engine refused a call: a line that names the cause."""


class ConfigError(EngineError, ValueError):
    """A task, a setting or a value that does not exist."""


class KeywordError(ConfigError, TypeError):
    """A keyword that no constructor has."""


class ActionError(EngineError, ValueError):
    """An action that is not a number or no id of the action set. No world has moved."""


#: What every environment takes and gives to the engine (training/c_api/cls_training.h).
KEYWORDS = ("obs", "features", "actions", "offense", "defense", "agents", "num_agents",
            "goalie_agent", "teammates", "opponent", "frame_skip", "max_cycles", "reward",
            "options", "types", "threads", "state", "start", "until", "look", "say",
            "expert")
#: Where an action mask is.
MASKS = ("info", "observation", "appended")
_HINTS = {"id": "did you mean task?", "num_envs": "VectorEnv has it",
          "autoreset": "VectorEnv has autoreset_mode",
          "autoreset_mode": "VectorEnv has it", "copy": "VectorEnv has it"}


def check_keywords(owner: str, config: Mapping[str, Any], own: Sequence[str]) -> None:
    """Raises KeywordError for a key of `config` that is none of KEYWORDS; `own` are the
    constructor's others, which are suggested, too."""
    known = [*KEYWORDS, *own]
    for key, value in config.items():
        if key in KEYWORDS:
            continue
        close = difflib.get_close_matches(key, known, 1, 0.5)
        hint = _HINTS.get(key) or (f"did you mean {close[0]}?" if close
                                   else f"keywords: {', '.join(known)}")
        raise KeywordError(f"{owner}: unknown keyword {key}={value!r:.60}; {hint}")


def check_choice(keyword: str, value: Any, choices: Sequence[str]) -> None:
    """Raises ConfigError for a value that is none of `choices`."""
    if value in choices:
        return
    close = difflib.get_close_matches(str(value), choices, 1, 0.5)
    hint = f"did you mean {close[0]!r}?" if close else f"one of {', '.join(choices)}"
    raise ConfigError(f"{keyword}: unknown {value!r:.60}; {hint}")


def plain(value: Any, keyword: str) -> Any:
    """`value` of numbers, texts, lists and dictionaries as JSON has them; NumPy's numbers count.
    Raises ConfigError for others, with the path in dictionaries: "reward.goal"."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not math.isfinite(value):
        raise ConfigError(f"{keyword}: must be a finite number, not {value}")
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, Mapping):
        return {str(key): plain(one, f"{keyword}.{key}") for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one, keyword) for one in value]
    raise ConfigError(f"{keyword}: must be a number, a text or a dictionary of them, not "
                      f"{type(value).__name__} {value!r:.60}")


#: What the engine says where it does not name the keyword.
_UNNAMED: List[Tuple[str, str]] = [("unknown feature set", "features"),
                                   ("the feature set", "features"),
                                   ("unknown action set", "actions")]


def readable(text: str) -> str:
    """A line of the engine about a JSON text as one about keywords:
    "configuration:1: /reward/gaol: unknown key 'gaol'" as "reward.gaol: unknown key 'gaol'"."""
    text = re.sub(r"^(configuration|options)(:\d+)*: ", "", text)
    for start, keyword in _UNNAMED:
        if text.startswith(start):
            return f"{keyword}: {text}"
    path = re.match(r"/([\w/]+): ", text)
    return f"{path[1].replace('/', '.')}: {text[path.end():]}" if path else text


def with_features(config: Dict[str, Any], task: Mapping[str, Any],
                  sets: Sequence[Mapping[str, Any]]) -> Dict[str, Any]:
    """`config` with "ego" where nothing is chosen, the agents are not attackers alone, and the
    task's own feature set (of the catalog's `sets`) is for attackers only."""
    for_attackers = {one["set"] for one in sets if one["offense_only"]}
    if "features" in config or config.get("agents", task["agents"]) == "offense" \
            or task["features"] not in for_attackers:
        return config
    return {**config, "features": "ego"}
