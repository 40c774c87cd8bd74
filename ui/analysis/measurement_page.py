"""Measured points against theory: open a file, best fit, statistics, topography and pitch errors."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from gearstudio.errors import FileError
from gearstudio.files import write_text
from gearstudio.theory.cones import PairGeometry
from ui.analysis.background import Newest
from ui.analysis.measurement_table import MeasurementTable
from ui.analysis.measurement_view import ALL_TEETH, Measurement, measured, pitch_chart, teeth, topography
from ui.charts.chart import Chart
from ui.charts.frame import ChartFrame, documents
from ui.charts.map_chart import MapChart
from ui.charts.maps import MapData
from ui.formatting import micrometres
from ui.method_bar import Segments
from ui.session import Session

POINT_FILES = "Measured points (*.csv *.dat *.txt *.asc *.ibl);;All files (*)"
VIEWS = (
    ("topography", "Topography", "Deviation as a bar at each point, both flanks drawn flat"),
    ("pitch", "Pitch", "Single and cumulative pitch errors"),
)
LEFT_WIDTH = 330
NOMINAL_GRID = (9, 5)


class MeasurementPage(QWidget):
    """File and best fit on the left with the numbers, charts beside them.

    Signals
    -------
    said(str, str)
    """

    said = Signal(str, str)
    _progressed = Signal(str, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._pair: PairGeometry | None = None
        self._member = "wheel"
        self._hint = ""
        self.path: Path | None = None
        self.measurement: Measurement | None = None
        self.work = Newest("measurement", self)
        self.open = QPushButton("Open points…")
        self.open.setToolTip("CSV, .dat, or columns x y z and, if there are, nx ny nz; in mm")
        self.nominal = QPushButton("Nominal grid…")
        self.nominal.setToolTip("Write the nominal points with normals, for a coordinate measuring machine")
        self.turn, self.shift = QCheckBox("Turn"), QCheckBox("Shift")
        self.turn.setToolTip("The best fit may turn the part about its axis")
        self.shift.setToolTip("The best fit may shift the part along its axis")
        self.file = QLabel("No points yet: open a file of measured points in mm, apex at the origin, axis along z.")
        self.file.setProperty("role", "muted")
        self.progress = QProgressBar(maximum=1000, textVisible=False)
        self.progress.hide()
        self.table = MeasurementTable()
        self.bars, self.pitch = MapChart(), Chart()
        self.charts = {"topography": self.bars, "pitch": self.pitch}
        self.stack = QStackedWidget()
        self.frame = ChartFrame(self.stack)
        self.views = Segments(VIEWS, "Chart")
        self.teeth = QComboBox()
        self.teeth.setToolTip("The tooth that is drawn")
        self._arrange()
        self._connect()

    def show_session(self, session: Session) -> None:
        """Measure against the session's member, when it is another one."""
        if (session.pair, session.member) != (self._pair, self._member):
            self._pair, self._member = session.pair, session.member
            self._request()

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self.bars.refresh_theme()
        self.pitch.refresh_theme()

    def close_page(self) -> None:
        """End the background work."""
        self.work.close()

    def open_path(self, path: Path) -> None:
        """Measure the points of a file."""
        self.path, self.measurement = path, None
        self._request()

    def save_nominal(self, path: Path) -> None:
        """Write the nominal grid of the member with its normals."""
        from gearstudio.exchange.measured import nominal_grid_text

        if self._pair is None:
            return
        try:
            write_text(path, nominal_grid_text(self._pair.member(self._member), *NOMINAL_GRID))
        except FileError as error:
            self.said.emit("error", f"The nominal grid was not saved: {error}")
        else:
            self.said.emit("info", f"Saved the nominal grid of the {self._member} as {path}")

    def show_view(self, view: str) -> None:
        """The topography or the pitch errors."""
        self.views.set_choice(view)
        self.frame.chart = self.charts[view]
        self.stack.setCurrentWidget(self.charts[view])
        self._show_teeth()

    # ---- inside --------------------------------------------------------------------------------------

    def _arrange(self) -> None:
        files = QHBoxLayout()
        files.addWidget(self.open)
        files.addWidget(self.nominal)
        files.addStretch(1)
        fit = QHBoxLayout()
        fit.setSpacing(12)
        label = QLabel("Best fit")
        label.setProperty("role", "muted")
        for widget in (label, self.turn, self.shift):
            fit.addWidget(widget)
        fit.addStretch(1)
        self.file.setWordWrap(True)
        self.file.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        left = QWidget()
        left.setFixedWidth(LEFT_WIDTH)
        column = QVBoxLayout(left)
        column.setContentsMargins(10, 6, 6, 4)
        column.setSpacing(5)
        column.addLayout(files)
        column.addLayout(fit)
        column.addWidget(self.file)
        column.addWidget(self.progress)
        column.addWidget(self.table, 1)
        column.addStretch(0)
        for chart in self.charts.values():
            self.stack.addWidget(chart)
        self.frame.add_control(self.views)
        self.frame.add_control(self.teeth)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(left)
        layout.addWidget(self.frame, 1)
        self.show_view("topography")

    def _connect(self) -> None:
        for box in (self.turn, self.shift):
            box.setChecked(True)
            box.toggled.connect(lambda _on: self._request())
        self.open.clicked.connect(self._ask)
        self.nominal.clicked.connect(self._ask_nominal)
        self.views.chosen.connect(self.show_view)
        self.teeth.activated.connect(lambda _index: self._draw())
        self.work.done.connect(self._on_done)
        self.work.failed.connect(self._on_failed)
        self.work.idle.connect(self.progress.hide)
        self._progressed.connect(self._on_progressed, Qt.ConnectionType.QueuedConnection)
        self.frame.said.connect(self.said)

    def _ask(self) -> None:
        name, _ = QFileDialog.getOpenFileName(self, "Open measured points", documents(), POINT_FILES)
        if name:
            self.open_path(Path(name))

    def _ask_nominal(self) -> None:
        start = f"{documents()}/{self._member}-nominal.csv"
        name, _ = QFileDialog.getSaveFileName(self, "Save nominal grid", start, "Points (*.csv)")
        if name:
            self.save_nominal(Path(name))

    def _request(self) -> None:
        pair, path, member = self._pair, self.path, self._member
        if pair is None or path is None:
            return
        known = self.measurement
        chunks = known.chunks if known is not None and known.path == path else None
        fit = (self.turn.isChecked(), self.shift.isChecked())
        self.progress.setValue(0)
        self.progress.show()
        report = self._progressed.emit
        self.work.request((pair, path, member), lambda: measured(pair, member, path, chunks, fit, report))

    def _on_progressed(self, _stage: str, fraction: float) -> None:
        self.progress.setValue(round(1000 * fraction))

    def _on_done(self, label: object, measurement: Measurement) -> None:
        if label != (self._pair, self.path, self._member):
            return
        self.measurement = measurement
        self._tell(f"{measurement.path.name}, against the {self._member}", "")
        self._fill_teeth()
        self.table.show_measurement(measurement)
        self.pitch.show_data(pitch_chart(measurement))
        self._draw()

    def _on_failed(self, label: object, text: str, details: str) -> None:
        if label != (self._pair, self.path, self._member):
            return
        self._tell(text, "error")
        self.table.clear()
        self.teeth.clear()
        self._hint = ""
        self._show_teeth()
        self.bars.show_data(MapData("topography"))
        self.pitch.show_data(replace(self.pitch.data, series=(), legend=(), note="No points"))

    def _tell(self, text: str, severity: str) -> None:
        self.file.setText(text)
        self.file.setProperty("severity", severity)
        self.file.style().polish(self.file)

    def _fill_teeth(self) -> None:
        assert self.measurement is not None
        found, before = teeth(self.measurement), self.teeth.currentData()
        with QSignalBlocker(self.teeth):
            self.teeth.clear()
            self.teeth.addItem("All teeth", ALL_TEETH)
            for tooth in found:
                self.teeth.addItem(f"Tooth {tooth + 1}", tooth)
            self.teeth.setCurrentIndex(max(0, self.teeth.findData(before)))
        self._show_teeth()

    def _show_teeth(self) -> None:
        """The choice of a tooth, where there is one, and what the bars mean."""
        bars = self.frame.chart is self.bars
        self.teeth.setVisible(bars and self.teeth.count() > 2)
        self.frame.set_hint(self._hint if bars else "")

    def _draw(self) -> None:
        if self.measurement is None:
            return
        tooth = self.teeth.currentData()
        data, largest = topography(self.measurement, ALL_TEETH if tooth is None else tooth)
        self.bars.show_data(data)
        self._hint = f"Longest: {micrometres(largest)}; up is metal added"
        self._show_teeth()
