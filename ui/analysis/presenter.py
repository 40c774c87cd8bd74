"""Keeps the page in sight in step with the session."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal

from ui.analysis.cad_jobs import CadJobs
from ui.session import Session

if TYPE_CHECKING:
    from ui.analysis.area import AnalysisArea
    from ui.analysis.page import Page
    from ui.runner import JobRunner

PAUSE_MS = 30


class AnalysisPresenter(QObject):
    """Shows the session on the page in sight, and on another one when the user goes there.

    Signals
    -------
    said(str, str)
        Severity and a line for the user.
    """

    said = Signal(str, str)

    def __init__(self, session: Session, area: AnalysisArea, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._area, self._jobs = session, area, CadJobs(self)
        self._timer = QTimer(self, singleShot=True, interval=PAUSE_MS)
        self._timer.timeout.connect(self._show)
        area.page_made.connect(self._on_page_made)
        facts = (session.results_changed, session.design_changed, session.selection_changed, area.tab_chosen)
        for signal in facts:
            signal.connect(self._show_soon)

    def use_charts(self) -> None:
        """The charts' library is loaded."""
        from ui.analysis.pages import factories

        self._area.use_factories(factories(self._jobs))

    def use_runner(self, runner: JobRunner) -> None:
        """The CAD process can be started."""
        self._jobs.use_runner(runner)

    def _show_soon(self) -> None:
        self._timer.start()

    def _on_page_made(self, page: Page) -> None:
        page.said.connect(self.said)
        self._show()

    def _show(self) -> None:
        page = self._area.page
        if page is not None and self._session.pair is not None:
            page.show_session(self._session)
