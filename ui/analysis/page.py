"""What the pages of the analysis area have in common."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtCore import SignalInstance

from ui.session import Session


class Page(Protocol):
    """A page shows the session when it is asked to; ``said`` carries a severity and a line for the user."""

    said: SignalInstance

    def show_session(self, session: Session) -> None: ...
    def refresh_theme(self) -> None: ...
    def close_page(self) -> None: ...
