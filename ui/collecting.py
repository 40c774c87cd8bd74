"""When the interpreter looks for garbage: never among the modules, which stay until the end."""

from __future__ import annotations

import gc


def keep_what_is_loaded() -> None:
    """Collect garbage from now on, but never again look through the modules that stay until the end.

    They are 280 000 objects; to look through them holds up the window for more than a tenth of a second.
    """
    gc.freeze()
    gc.enable()


def tidy_memory() -> None:
    """Free what a window has left, also where the collector does not look any more."""
    frozen = gc.get_freeze_count() > 0
    gc.unfreeze()
    gc.collect()
    if frozen:
        gc.freeze()
