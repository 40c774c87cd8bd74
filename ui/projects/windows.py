"""Another window is another process: each has its own CAD process, and none can take the other down."""

from __future__ import annotations

import sys
from pathlib import Path

from PySide6.QtCore import QProcess

from ui.language import spoken

PROGRAM = Path(__file__).resolve().parents[2] / "main.py"


def command(*arguments: str) -> list[str]:
    """How this program is started with these arguments."""
    frozen = getattr(sys, "frozen", False)
    return [sys.executable, *arguments] if frozen else [sys.executable, str(PROGRAM), *arguments]


def open_window(*arguments: str) -> bool:
    """Start another GearStudio in the language of this one; False when the system refuses."""
    program, *rest = command(*arguments, "--language", spoken())
    return bool(QProcess.startDetached(program, rest)[0])
