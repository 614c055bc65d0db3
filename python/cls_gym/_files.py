"""Files that are complete or as they were before."""
from __future__ import annotations

import contextlib
import os
import pathlib
from typing import Iterator, Union

__all__ = ["replaced"]


@contextlib.contextmanager
def replaced(path: Union[str, pathlib.Path]) -> Iterator[pathlib.Path]:
    """A name for the new content of `path`, which takes its place when the block ends. After an
    error, or when the process is killed, `path` has its old content. Devices and pipes are written
    directly."""
    target = pathlib.Path(os.path.realpath(path))
    if target.exists() and not target.is_file():
        yield target
        return
    partial = target.with_name(f".{target.name}.{os.getpid()}.partial")
    try:
        yield partial
        os.replace(partial, target)
    except OSError as error:
        if error.filename is not None and os.fspath(error.filename) == str(partial):
            error.filename = os.fspath(path)
        raise
    finally:
        partial.unlink(missing_ok=True)
