"""The end of the program."""

from __future__ import annotations

import contextlib
import logging
import os
import sys
from typing import NoReturn


def leave(status: int) -> NoReturn:
    """End the process at once, after the window has closed in good order.

    What is left are objects of Python, Qt and the renderer that refer to each other. The interpreter would free them
    in an order that nobody chose, some of them after the application and its graphics context, which can crash.
    """
    logging.shutdown()
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(OSError, ValueError, AttributeError):
            stream.flush()
    os._exit(status)
