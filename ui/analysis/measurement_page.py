"""Measured points against theory: open a file or a model, best fit, statistics, topography, pitch errors, 3D."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QStackedWidget, QWidget

from gearstudio.errors import FileError
from gearstudio.exchange.measured import is_model
from gearstudio.files import write_text
from gearstudio.theory.cones import PairGeometry
from ui.analysis.cad_jobs import CadJobs
from ui.analysis.measured_view import MeasuredView
from ui.analysis.measurement_data import ALL_TEETH, Measurement, Source
from ui.analysis.measurement_panel import MeasurementPanel
from ui.analysis.measurement_work import Against, Asked, Drawn, MeasurementWork
from ui.charts.chart import Chart
from ui.charts.frame import ChartFrame
from ui.charts.map_chart import MapChart
from ui.charts.maps import MapData
from ui.formatting import micrometres
from ui.method_bar import Segments
from ui.session import Session
from ui.views.factors import factor_rows
from ui.views.quiet import QuietChoice
from ui.words import told, tr

NOMINAL_GRID = (9, 5)


class MeasurementPage(QWidget):
    """File and best fit on the left with the numbers, charts beside them.

    Points of a file are read and measured in a thread; those of a model are taken in the CAD process first.

    Signals
    -------
    said(str, str)
    """

    said = Signal(str, str)

    def __init__(self, jobs: CadJobs | None = None, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pair: PairGeometry | None = None
        self._hint = ""
        self.measurement: Measurement | None = None
        self.work = MeasurementWork(jobs or CadJobs(self), self)
        self.panel = MeasurementPanel()
        self.bars, self.pitch, self.space = MapChart(), Chart(), MeasuredView()
        self.charts = {"topography": self.bars, "pitch": self.pitch, "space": self.space}
        self.stack = QStackedWidget()
        for chart in self.charts.values():
            self.stack.addWidget(chart)
        self.frame = ChartFrame(self.stack)
        self.views = Segments(
            (
                ("topography", tr("Topography"), tr("Deviation as a bar at each point, both flanks drawn flat")),
                ("pitch", tr("Pitch"), tr("Single and cumulative pitch errors")),
                ("space", tr("3D"), tr("Measured points on the gear, coloured by their deviation")),
            ),
            tr("Chart"),
        )
        self.teeth = QComboBox()
        self.teeth.setToolTip(tr("The tooth that is drawn"))
        self.teeth.setAccessibleName(tr("Tooth"))
        self.frame.add_control(self.views)
        self.exaggeration = QuietChoice(
            factor_rows(), tr("Exaggerate"), tr("Draw deviations so many times as large, along the normal")
        )
        self.exaggeration.chosen.connect(self.space.exaggerate)
        self.frame.add_control(self.teeth)
        self.frame.add_control(self.exaggeration)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.panel)
        layout.addWidget(self.frame, 1)
        self._connect()
        self.show_view("topography")

    @property
    def busy(self) -> bool:
        """Whether a measurement is being made."""
        return self.work.busy

    def show_session(self, session: Session) -> None:
        """Measure against the session's member, when it is another one."""
        if session.pair is None or (session.pair, session.member) == (self._pair, self.panel.member):
            return
        self._pair, self.panel.member = session.pair, session.member
        self.work.set_against(Against(session.design, session.pair, session.member))
        self._request()

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        for chart in self.charts.values():
            chart.refresh_theme()

    def close_page(self) -> None:
        """End the background work."""
        self.work.close()
        self.space.close_view()

    def open_path(self, path: Path) -> None:
        """Measure the points of a file, or of the flanks in a STEP file."""
        self.measurement = None
        self.work.open(path)
        self.panel.tell(tr("Reading {file}…", file=path.name))
        self.panel.show_density(is_model(path))
        self._request()

    def keep_state(self) -> object:
        """The points, read, for `take_state`."""
        return self.work.source

    def take_state(self, state: object) -> None:
        """Measure the points of another window."""
        if isinstance(state, Source):
            self.work.source = state
            self.panel.show_density(is_model(state.path))
            self._request()

    def save_nominal(self, path: Path) -> None:
        """Write the nominal grid of the member with its normals."""
        from gearstudio.exchange.measured import nominal_grid_text

        if self._pair is None:
            return
        try:
            write_text(path, nominal_grid_text(self._pair.member(self.panel.member), *NOMINAL_GRID))
        except FileError as error:
            self.said.emit("error", tr("The nominal grid was not saved: {reason}", reason=told(error)))
        else:
            self.said.emit(
                "info", tr("Saved the nominal grid of the {member} as {path}", member=tr(self.panel.member), path=path)
            )

    def show_view(self, view: str) -> None:
        """The topography, the pitch errors or the points in space."""
        self.views.set_choice(view)
        self.frame.chart = self.charts[view]
        self.stack.setCurrentWidget(self.charts[view])
        self._show_teeth()

    # ---- inside --------------------------------------------------------------------------------------

    def _connect(self) -> None:
        panel, work = self.panel, self.work
        panel.path_chosen.connect(self.open_path)
        panel.nominal_wanted.connect(self.save_nominal)
        panel.fit_changed.connect(self._request)
        panel.density_changed.connect(lambda: self.work.source is not None and self.open_path(self.work.source.path))
        panel.cancelled.connect(work.cancel)
        self.views.chosen.connect(self.show_view)
        self.teeth.activated.connect(lambda _index: self._draw())
        work.measured.connect(self._on_measured)
        work.redrawn.connect(self._show)
        work.refused.connect(self._show_refusal)
        work.cancelled.connect(self._on_cancelled)
        work.progressed.connect(panel.show_progress)
        self.frame.said.connect(self.said)

    def _request(self) -> None:
        self.work.request(Asked(self.panel.fit, self.panel.points_per_face, self._tooth))

    def _on_cancelled(self) -> None:
        if self.measurement is None:
            self.work.open(None)
            self.panel.show_density(False)
            self._show_refusal(tr("The measurement was cancelled."), "")

    def _on_measured(self, measurement: Measurement, made: Drawn) -> None:
        self.measurement = measurement
        doubts = [told(doubt.message) for doubt in measurement.result.warnings]
        self.panel.tell("\n".join([_words(measurement), *doubts]), "warning" if doubts else "")
        self._fill_teeth(measurement)
        self.panel.table.show_measurement(measurement)
        self._show(made)

    def _show_refusal(self, text: str, severity: str = "error") -> None:
        self.measurement = None
        self.panel.tell(told(text), severity)
        self.panel.table.clear()
        self.teeth.clear()
        self._hint = ""
        self._show_teeth()
        self.bars.show_data(MapData("topography"))
        self.pitch.show_data(replace(self.pitch.data, series=(), legend=(), note=tr("No points")))
        self.space.clear()

    def _fill_teeth(self, measurement: Measurement) -> None:
        before = self.teeth.currentData()
        with QSignalBlocker(self.teeth):
            self.teeth.clear()
            self.teeth.addItem(tr("All teeth"), ALL_TEETH)
            for tooth in measurement.teeth:
                self.teeth.addItem(tr("Tooth {number}", number=tooth + 1), tooth)
            self.teeth.setCurrentIndex(max(0, self.teeth.findData(before)))
        self._show_teeth()

    def _show_teeth(self) -> None:
        """The choice of a tooth, where there is one, and what the bars mean."""
        pitch = self.frame.chart is self.pitch
        self.teeth.setVisible(not pitch and self.teeth.count() > 2)
        self.exaggeration.setVisible(self.frame.chart is self.space)
        self.frame.set_hint(self._hint if self.frame.chart is self.bars else "")

    @property
    def _tooth(self) -> int:
        tooth = self.teeth.currentData()
        return ALL_TEETH if tooth is None else int(tooth)

    def _draw(self) -> None:
        if self.measurement is not None:
            self.work.redraw(self.measurement, self._tooth)

    def _show(self, made: Drawn) -> None:
        measurement = self.measurement
        if measurement is None:
            return
        self.bars.show_data(made.bars)
        self.pitch.show_data(made.pitch)
        self.space.numbers = made.bars.table
        self.space.show_points(measurement.member, made.layers, measurement.source.path.name, made.largest_um)
        self._hint = tr("Longest: {length}; up is metal added", length=micrometres(made.largest_um))
        self._show_teeth()


def _words(measurement: Measurement) -> str:
    source, member = measurement.source, tr(measurement.member.name)
    if source.faces is None:
        return tr("{file}, against the {member}", file=source.path.name, member=member)
    return tr(
        "{file}, against the {member}: points of {flanks} flank faces of {faces}",
        file=source.path.name, member=member, flanks=source.faces[0], faces=source.faces[1],
    )  # fmt: skip
