"""Charts of the deviations of all methods and variants."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QVBoxLayout, QWidget

from gearstudio.theory.flank import FLANKS
from ui.analysis.deviation_series import PATHS, Choice, deviation_chart, histogram_chart
from ui.charts.chart import Chart
from ui.charts.frame import ChartFrame
from ui.method_bar import Segments
from ui.session import Session

KINDS = (
    ("points", "Points", "Deviation along a series of points, as the paper's Fig. 12"),
    ("histogram", "Histogram", "How often which deviation occurs"),
)


class ChartsPage(QWidget):
    """One chart at a time, with its choices over it.

    Signals
    -------
    said(str, str)
    """

    said = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session: Session | None = None
        self._choice = Choice("wheel", "concave")
        self.kind = "points"
        self.chart = Chart()
        self.frame = ChartFrame(self.chart)
        self.kinds = Segments(KINDS, "Chart")
        self.flanks = Segments([(f, f.capitalize(), f"The {f} flank") for f in FLANKS], "Flank")
        self.paths = QComboBox()
        for identifier, title, tip in PATHS:
            self.paths.addItem(title, identifier)
            self.paths.setItemData(self.paths.count() - 1, tip, 3)
        self.paper = QCheckBox("Paper")
        self.paper.setToolTip("The deviations that the paper states of its own gear, for comparison")
        self.paper.setChecked(True)
        self.scale = QComboBox()
        for title, value in (("Auto scale", None), ("Log scale", True), ("Linear scale", False)):
            self.scale.addItem(title, value)
        self.scale.setToolTip("Auto is logarithmic where the curves differ by orders")
        for control in (self.kinds, self.flanks, self.paths, self.scale, self.paper):
            self.frame.add_control(control)
        self.kinds.set_choice(self.kind)
        self.flanks.set_choice(self._choice.flank)
        self.kinds.chosen.connect(self._choose_kind)
        self.flanks.chosen.connect(lambda flank: self._choose(flank=flank))
        self.paths.activated.connect(lambda _index: self._choose(path=self.paths.currentData()))
        self.scale.activated.connect(lambda _index: self._choose(log=self.scale.currentData()))
        self.paper.toggled.connect(lambda on: self._choose(paper=on))
        self.frame.said.connect(self.said)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.frame)

    def show_session(self, session: Session) -> None:
        """Draw the session's results."""
        self._session = session
        self._choose(member=session.member)

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self.chart.refresh_theme()

    def close_page(self) -> None:
        """Nothing runs here."""

    def _choose_kind(self, kind: str) -> None:
        self.kind = kind
        self.paths.setVisible(kind == "points")
        self._choose()

    def _choose(self, **changes: object) -> None:
        self._choice = replace(self._choice, **changes)
        if self._session is None:
            return
        make = deviation_chart if self.kind == "points" else histogram_chart
        self.chart.show_data(make(self._session.results, self._choice))
        self.frame.set_hint(_hint(self.kind, self._choice))


def _hint(kind: str, choice: Choice) -> str:
    if kind == "histogram":
        return f"{choice.member.capitalize()}, {choice.flank} flank: all points of the deviation map"
    return f"{choice.member.capitalize()}: {next(tip for name, _, tip in PATHS if name == choice.path)}"
