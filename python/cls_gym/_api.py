"""Base classes: Gymnasium's where it is installed, else classes with the same methods."""
from __future__ import annotations

import enum
import re
import warnings
from typing import Any, Dict, Optional

import numpy as np

from cls_gym._config import ConfigError
from cls_gym.seeding import generator

#: The oldest Gymnasium that has what the classes here need.
GYMNASIUM = "1.1"
#: Set if there is an older one: its version. The classes are none of Gymnasium's then.
old_gymnasium: Optional[str] = None

try:
    import gymnasium  # type: ignore[import-not-found,unused-ignore]
except ImportError:
    pass
else:
    _version = getattr(gymnasium, "__version__", "of unknown version")
    if [int(part) for part in re.findall(r"\d+", _version)[:2]] < [1, 1]:
        old_gymnasium = _version


def check_gymnasium(owner: str) -> None:
    """Raises ImportError where an older Gymnasium is installed, whose wrappers would refuse
    `owner` or misuse it."""
    if old_gymnasium is not None:
        raise ImportError(f"cls_gym.{owner}: Gymnasium {old_gymnasium} is too old, {GYMNASIUM} or "
                          "later is needed: pip install --upgrade gymnasium")


try:
    if old_gymnasium is not None:
        raise ImportError
    from gymnasium.vector import (  # type: ignore[import-not-found,unused-ignore]
        AutoresetMode as AutoresetMode)

    BaseEnv: Any = gymnasium.Env
    BaseVectorEnv: Any = gymnasium.vector.VectorEnv
    ResetNeeded: Any = gymnasium.error.ResetNeeded
    ClosedEnvironmentError: Any = gymnasium.error.ClosedEnvironmentError

    def warn(text: str) -> None:
        """Warns as Gymnasium does."""
        gymnasium.logger.warn(text)

except ImportError:

    class AutoresetMode(enum.Enum):  # type: ignore[no-redef,unused-ignore]
        """When a vector environment starts the next episode of one that has ended."""

        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

    class ResetNeeded(Exception):  # type: ignore[no-redef,unused-ignore]
        """step() before reset()."""

    class ClosedEnvironmentError(Exception):  # type: ignore[no-redef,unused-ignore]
        """A call after close()."""

    class BaseEnv:  # type: ignore[no-redef,unused-ignore]
        """What gymnasium.Env brings, as far as cls_gym uses it."""

        metadata: Dict[str, Any] = {}
        render_mode: Optional[str] = None
        spec: Any = None
        _np_random: Optional[np.random.Generator] = None

        @property
        def unwrapped(self) -> Any:
            return self

        @property
        def np_random(self) -> np.random.Generator:
            """The random numbers from which the seeds of episodes come."""
            if self._np_random is None:
                self._np_random = generator(None)
            return self._np_random

        def reset(self, *, seed: Optional[int] = None,
                  options: Optional[Dict[str, Any]] = None) -> Any:
            if seed is not None:
                self._np_random = generator(seed)

        def close(self) -> None:
            pass

        def __enter__(self) -> Any:
            return self

        def __exit__(self, *_: Any) -> None:
            self.close()

    class BaseVectorEnv(BaseEnv):  # type: ignore[misc,no-redef,unused-ignore]
        """What gymnasium.vector.VectorEnv brings, as far as cls_gym uses it."""

        closed = False

        def close(self, **kwargs: Any) -> None:
            if not self.closed:
                self.close_extras(**kwargs)
                self.closed = True

        def close_extras(self, **kwargs: Any) -> None:
            pass

    def warn(text: str) -> None:
        """Warns as Python does."""
        warnings.warn(text, stacklevel=3)


def mode_of(name: Any) -> AutoresetMode:
    """A mode by name: "NextStep", "next_step" or the mode itself."""
    if isinstance(name, AutoresetMode):
        return name
    for mode in AutoresetMode:
        if str(name).replace("_", "").lower() == mode.value.replace("_", "").lower():
            return mode
    modes = ", ".join(mode.name.lower() for mode in AutoresetMode)
    raise ConfigError(f"autoreset_mode: unknown {name!r}; modes: {modes}")
