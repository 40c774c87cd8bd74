"""What is measured and how: file, density, best fit, progress, and below them the numbers."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ui.analysis.measurement_table import MeasurementTable
from ui.charts.frame import documents
from ui.words import tr

LEFT_WIDTH = 330
DENSITIES = (("Coarse", 10.0), ("Usual", 20.0), ("Fine", 50.0))
"""Points along the face width that are taken of a CAD model."""


class MeasurementPanel(QWidget):
    """The left side of the measurement page.

    Signals
    -------
    path_chosen(object)
        A file of points, or a CAD model.
    nominal_wanted(object)
        Where to write the nominal grid.
    fit_changed()
    density_changed()
    cancelled()
    """

    path_chosen = Signal(object)
    nominal_wanted = Signal(object)
    fit_changed = Signal()
    density_changed = Signal()
    cancelled = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.member = "wheel"
        self.open = QPushButton(tr("Open points or STEP…"))
        self.open.setToolTip(
            tr("CSV, .dat, or columns x y z and, if there are, nx ny nz, in mm; or a STEP file of the gear")
        )
        self.nominal = QPushButton(tr("Nominal grid…"))
        self.nominal.setToolTip(tr("Write the nominal points with normals, for a coordinate measuring machine"))
        self.turn, self.shift = QCheckBox(tr("Turn")), QCheckBox(tr("Shift"))
        self.turn.setToolTip(tr("The best fit may turn the part about its axis"))
        self.shift.setToolTip(tr("The best fit may shift the part along its axis"))
        self.density = QComboBox()
        for title, count in DENSITIES:
            self.density.addItem(tr(title), count)
        self.density.setCurrentIndex(1)
        self.density.setToolTip(tr("How many points are taken of a CAD model's flanks"))
        self.density.setAccessibleName(tr("Density of points"))
        self.file = QLabel(
            tr("No points yet: open a file of measured points in mm, or a STEP file; apex at the origin, axis along z.")
        )
        self.file.setProperty("role", "muted")
        self.progress = QProgressBar(maximum=1000, textVisible=False)
        self.progress.setAccessibleName(tr("Progress of the measurement"))
        self.stop = QPushButton(tr("Cancel"))
        self.stop.setToolTip(tr("End the measurement"))
        self.table = MeasurementTable()
        self._arrange()
        for box in (self.turn, self.shift):
            box.setChecked(True)
            box.toggled.connect(lambda _on: self.fit_changed.emit())
        self.open.clicked.connect(self._ask)
        self.nominal.clicked.connect(self._ask_nominal)
        self.stop.clicked.connect(self.cancelled)
        self.density.activated.connect(lambda _index: self.density_changed.emit())
        self.show_density(False)
        self.show_progress(None)

    @property
    def fit(self) -> tuple[bool, bool]:
        """Whether the best fit may turn, and shift."""
        return self.turn.isChecked(), self.shift.isChecked()

    @property
    def points_per_face(self) -> float:
        """Points along the face width that are taken of a model."""
        return float(self.density.currentData())

    def show_density(self, shown: bool) -> None:
        """Points of a CAD model may be more or fewer."""
        self.density.setVisible(shown)

    def show_progress(self, fraction: float | None) -> None:
        """How far the work is; None when there is none."""
        for widget in (self.progress, self.stop):
            widget.setVisible(fraction is not None)
        self.progress.setValue(round(1000 * (fraction or 0.0)))

    def tell(self, text: str, severity: str = "") -> None:
        """Say what is measured, or why it cannot be."""
        self.file.setText(text)
        self.file.setProperty("severity", severity)
        self.file.style().polish(self.file)

    def _arrange(self) -> None:
        files, fit, work = QHBoxLayout(), QHBoxLayout(), QHBoxLayout()
        files.addWidget(self.open)
        files.addWidget(self.nominal)
        files.addStretch(1)
        fit.setSpacing(12)
        label = QLabel(tr("Best fit"))
        label.setProperty("role", "muted")
        for widget in (label, self.turn, self.shift):
            fit.addWidget(widget)
        fit.addStretch(1)
        fit.addWidget(self.density)
        work.addWidget(self.progress, 1)
        work.addWidget(self.stop)
        self.file.setWordWrap(True)
        self.file.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.file.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFixedWidth(LEFT_WIDTH)
        column = QVBoxLayout(self)
        column.setContentsMargins(10, 6, 6, 4)
        column.setSpacing(5)
        column.addLayout(files)
        column.addLayout(fit)
        column.addWidget(self.file)
        column.addLayout(work)
        column.addWidget(self.table, 1)
        column.addStretch(0)

    def _ask(self) -> None:
        kinds = (
            f"{tr('Measured points and models')} (*.csv *.dat *.txt *.asc *.ibl *.step *.stp);;{tr('All files')} (*)"
        )
        name, _ = QFileDialog.getOpenFileName(self, tr("Open measured points or a STEP file"), documents(), kinds)
        if name:
            self.path_chosen.emit(Path(name))

    def _ask_nominal(self) -> None:
        start = f"{documents()}/{self.member}-nominal.csv"
        name, _ = QFileDialog.getSaveFileName(self, tr("Save nominal grid"), start, f"{tr('Points')} (*.csv)")
        if name:
            self.nominal_wanted.emit(Path(name))
