"""Charts of the deviations of all methods and variants."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QStackedWidget, QVBoxLayout, QWidget

from gearstudio.catalogue import METHOD_IDS
from gearstudio.theory.flank import FLANKS
from ui.analysis.cad_jobs import CadJobs
from ui.analysis.convergence_part import ConvergencePart
from ui.analysis.curvature_view import QUANTITIES, Wanted, curvature_maps
from ui.analysis.deviation_series import PATHS, Choice, deviation_chart, histogram_chart
from ui.charts.chart import Chart
from ui.charts.frame import ChartFrame
from ui.charts.map_chart import MapChart
from ui.method_bar import Segments
from ui.session import Key, Session
from ui.words import tr

KINDS = (
    ("points", "Points", "Deviation along a series of points, as the paper's Fig. 12"),
    ("histogram", "Histogram", "How often which deviation occurs"),
    ("convergence", "Convergence", "Deviation against positions, sections or points, poles, and seconds"),
    ("curvature", "Curvature", "Curvature of the modelled flanks, as the paper's Fig. 11, or its difference to theory"),
)


class ChartsPage(QWidget):
    """One chart at a time, with its choices over it.

    Signals
    -------
    said(str, str)
    """

    said = Signal(str, str)

    def __init__(self, jobs: CadJobs | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.convergence = ConvergencePart(jobs or CadJobs(self), self)
        self._session: Session | None = None
        self._choice = Choice("wheel", "concave")
        self.kind, self._hint = "points", ""
        self.chart, self.map = Chart(), MapChart()
        self.stack = QStackedWidget()
        self.stack.addWidget(self.chart)
        self.stack.addWidget(self.map)
        self.frame = ChartFrame(self.stack)
        self.kinds = Segments(KINDS, tr("Chart"))
        self.flanks = Segments([(f, f.capitalize(), tr("The {flank} flank", flank=tr(f))) for f in FLANKS], tr("Flank"))
        self.paths = QComboBox()
        for identifier, title, tip in PATHS:
            self.paths.addItem(tr(title), identifier)
            self.paths.setItemData(self.paths.count() - 1, tr(tip), Qt.ItemDataRole.ToolTipRole)
        self.paper = QCheckBox(tr("Paper"))
        self.paper.setToolTip(tr("The deviations that the paper states of its own gear, for comparison"))
        self.paper.setChecked(True)
        self.scale = QComboBox()
        for title, value in ((tr("Auto"), None), (tr("Log scale"), True), (tr("Linear"), False)):
            self.scale.addItem(title, value)
        self.scale.setToolTip(tr("Scale of the deviations: Auto is logarithmic where the curves differ by orders"))
        self.quantities, self.against = QComboBox(), QComboBox()
        for identifier, title, unit in QUANTITIES:
            self.quantities.addItem(tr(title), identifier)
            self.quantities.setItemData(self.quantities.count() - 1, f"[{unit}]", Qt.ItemDataRole.ToolTipRole)
        self.against.addItem(tr("CAD surface"), False)
        self.against.addItem(tr("Less theory"), True)
        for combo, name in (
            (self.paths, tr("Series of points")),
            (self.scale, tr("Scale")),
            (self.quantities, tr("Curvature")),
            (self.against, tr("Surface or difference")),
        ):
            combo.setAccessibleName(name)
        curves, maps = (self.paths, self.scale, self.paper), (self.quantities, self.against)
        self._own = {"points": curves, "histogram": curves[1:], "curvature": maps}
        self._own = {kind: (self.flanks, *own) for kind, own in self._own.items()}
        self._own["convergence"] = self.convergence.controls
        for control in (self.kinds, self.flanks, *curves, *maps, *self.convergence.controls):
            self.frame.add_control(control)
        self.kinds.set_choice(self.kind)
        self.flanks.set_choice(self._choice.flank)
        self.kinds.chosen.connect(self.show_kind)
        self.flanks.chosen.connect(lambda flank: self._choose(flank=flank))
        self.paths.activated.connect(lambda _index: self._choose(path=self.paths.currentData()))
        self.scale.activated.connect(lambda _index: self._choose(log=self.scale.currentData()))
        for combo in (self.quantities, self.against):
            combo.activated.connect(lambda _index: self._choose())
        self.map.pointed.connect(lambda text: self.frame.set_hint(text or self._hint))
        self.paper.toggled.connect(lambda on: self._choose(paper=on))
        self.convergence.changed.connect(lambda: self.kind == "convergence" and self._choose())
        self.frame.said.connect(self.said)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.frame)
        self.show_kind(self.kind)

    def show_session(self, session: Session) -> None:
        """Draw the session's results."""
        self._session = session
        self.convergence.show_session(session)
        self._choose(member=session.member)

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self.chart.refresh_theme()
        self.map.refresh_theme()

    def show_units(self) -> None:
        """Show curvatures in the unit chosen."""
        self._choose()

    def close_page(self) -> None:
        """Ask for nothing more."""
        self.convergence.stop()

    def keep_state(self) -> object:
        """What was computed for it, for `take_state`."""
        return self.convergence.keep_state()

    def take_state(self, state: object) -> None:
        """Have what was computed in another window."""
        self.convergence.take_state(state)

    def show_kind(self, kind: str) -> None:
        """Another chart, with its own choices."""
        self.kind = kind
        self.kinds.set_choice(kind)
        for controls in self._own.values():
            for control in controls:
                control.setVisible(control in self._own[kind])
        self.frame.chart = self.map if kind == "curvature" else self.chart
        self.stack.setCurrentWidget(self.frame.chart)
        self._choose()

    def _choose(self, **changes: object) -> None:
        self._choice = replace(self._choice, **changes)
        if self._session is None:
            return
        if self.kind == "curvature":
            self._show_curvature(self._session)
        elif self.kind == "convergence":
            self.chart.show_data(self.convergence.chart)
            self._hint = self.convergence.hint
        else:
            make = deviation_chart if self.kind == "points" else histogram_chart
            self.chart.show_data(make(self._session.results, self._choice))
            self._hint = _hint(self.kind, self._choice)
        self.frame.set_hint(self._hint)

    def _show_curvature(self, session: Session) -> None:
        wanted = Wanted(self._choice.flank, self.quantities.currentData(), self.against.currentData())
        keys = tuple(Key(session.member, method, session.variant) for method in METHOD_IDS)
        member = session.pair.member(session.member)
        current = {key: result for key, result in session.results.items() if key in session.current}
        data, self._hint = curvature_maps(current, keys, member, wanted)
        self.map.show_data(data)


def _hint(kind: str, choice: Choice) -> str:
    if kind == "histogram":
        return tr(
            "{member}, {flank} flank: all points of the deviation map",
            member=tr(choice.member.capitalize()),
            flank=tr(choice.flank),
        )
    return f"{tr(choice.member.capitalize())}: {tr(next(tip for name, _, tip in PATHS if name == choice.path))}"
