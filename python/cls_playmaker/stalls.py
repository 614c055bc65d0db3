"""Watches calls of a Playmaker that do not return: a log line names the player and the line."""
from __future__ import annotations

import contextlib
import faulthandler
import logging
import os
import sys
import threading
import time
import traceback
from typing import Any, Callable, Dict, Iterator, List, Optional, Sequence

_log = logging.getLogger("cls_playmaker")
_OWN = os.path.dirname(__file__) + os.sep
_INSTALLED = ("site-packages", "dist-packages")  # the latter of Debian
_PATIENCE = 3.0  # seconds; a match gives up after ten (--stall-after)
_INTERVAL = 0.5
_FRAMES = 3      # of the stack, innermost last
_DEBUGGERS = (os.sep + "bdb.py", os.sep + "pydevd.py")


def own_frames(frames: Sequence[traceback.FrameSummary]) -> List[traceback.FrameSummary]:
    """Those of the team: outside this package and installed ones."""
    return [frame for frame in frames if not frame.filename.startswith(_OWN)
            and not any(os.sep + folder + os.sep in frame.filename for folder in _INSTALLED)]


class _Call:
    def __init__(self, caller: Callable[[], str], name: str) -> None:
        self.caller = caller
        self.name = name
        self.since = time.monotonic()
        self.reported = False


class Stalls:
    """Knows the calls under way, one per thread. A thread of its own, which never ends, looks at
    them: all servers of a program share STALLS.

    Where a library holds Python's lock no thread can look: faulthandler then prints all stacks.
    """

    def __init__(self, patience: float = _PATIENCE) -> None:
        self._patience = patience
        self._calls: Dict[int, _Call] = {}
        self._watcher: Optional[threading.Thread] = None

    @contextlib.contextmanager
    def watch(self, name: str, caller: Callable[[], str]) -> Iterator[None]:
        """Around the method `name` for the agent that `caller` names."""
        if self._watcher is None:
            self._arm()
            self._watcher = threading.Thread(target=self._look, name="cls stalls",
                                             daemon=True)
            self._watcher.start()
        thread = threading.get_ident()
        outer = self._calls.get(thread)
        self._calls[thread] = _Call(caller, name)
        try:
            yield
        finally:
            if outer is None:
                del self._calls[thread]
            else:
                self._calls[thread] = outer

    def _look(self) -> None:
        while True:
            time.sleep(_INTERVAL)
            self._arm()
            for thread, call in dict(self._calls).items():
                if not call.reported and time.monotonic() - call.since > self._patience:
                    call.reported = True
                    self._report(call, sys._current_frames().get(thread))

    def _report(self, call: _Call, frame: Any) -> None:
        stack = traceback.extract_stack(frame) if frame is not None else traceback.StackSummary()
        if any(one.filename.endswith(_DEBUGGERS) for one in stack):
            return
        called = max((i for i, one in enumerate(stack) if one.filename.startswith(_OWN)), default=-1)
        own = own_frames(stack[called + 1:])[-_FRAMES:]
        place = f"{os.path.basename(own[-1].filename)}:{own[-1].lineno}" if own else "unknown"
        lines = [f"  {one.filename}:{one.lineno} in {one.name}: {one.line}" for one in own]
        _log.error("%s: %s has not returned for %.0f s, it is at %s\n%s", call.caller(), call.name,
                   time.monotonic() - call.since, place, "\n".join(lines))

    def _arm(self) -> None:
        """Sets the timer of faulthandler again: it runs out only if the watcher cannot run."""
        with contextlib.suppress(OSError, RuntimeError, ValueError, AttributeError):  # no stderr
            faulthandler.dump_traceback_later(2 * self._patience)


STALLS = Stalls()
