"""The whole program in tests: what is waited for, and what a user does."""

from __future__ import annotations

from ui.app import Studio

PATIENCE_MS = 90_000
TEETH = "pair.pinion_teeth"


def complete(studio: Studio) -> bool:
    """Whether there are views, and all that they are to show of what was typed last is built."""
    session = studio.session
    session.settle()
    return studio.window.area.grid is not None and session.pair is not None and not session.missing_keys()


def edit(studio: Studio, path: str, value: object) -> None:
    studio.window.form.field_edited.emit(path, value)
