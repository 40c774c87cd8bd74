"""What a solid is and how it is shown: state and build, edges, deviation, section, measuring, material, properties."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from ui.card import ScrollCard
from ui.formatting import CONSTRUCTION_TITLES
from ui.progress import set_progress
from ui.properties_table import PropertiesTable
from ui.solid_section import SolidSection
from ui.status import Dot
from ui.words import tr


class SolidPanel(QWidget):
    """Shows what it is told and announces what is chosen.

    Signals
    -------
    build_requested()
    construction_chosen(str)
    automatic_switched(bool)
    looks_changed()
        Edges or deviation.
    measure_switched(bool)
    units_shown()
        Lengths are to be shown in another unit.
    """

    build_requested = Signal()
    construction_chosen = Signal(str)
    automatic_switched = Signal(bool)
    looks_changed = Signal()
    measure_switched = Signal(bool)
    units_shown = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        card = ScrollCard((12, 10, 10, 8))
        rows = card.rows
        self.section = SolidSection()
        rows.addLayout(self._make_state())
        rows.addLayout(self._make_looks())
        rows.addWidget(self.section)
        rows.addLayout(self._make_measure())
        self.properties = PropertiesTable()
        rows.addSpacing(4)
        rows.addWidget(self.properties)
        rows.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2, 0, 8, 4)
        layout.addWidget(card)
        self.setMinimumWidth(262)
        self.show_state(tr("Not built yet"), "muted", None)

    # ---- what is chosen ------------------------------------------------------------------------------

    @property
    def edges(self) -> bool:
        """Whether edges are drawn."""
        return self._edges.isChecked()

    @property
    def deviation(self) -> bool:
        """Whether flanks are coloured by their deviation."""
        return self._deviation.isChecked()

    @property
    def measuring(self) -> bool:
        """Whether clicks measure."""
        return self._measure.isChecked()

    # ---- what is shown -------------------------------------------------------------------------------

    def show_state(self, text: str, color: str, fraction: float | None) -> None:
        """State of the solids in a few words with a lamp; a fraction shows the bar."""
        self._state.setText(text)
        self._lamp.set_color(color)
        self._progress.setVisible(fraction is not None)
        self._build.setEnabled(fraction is None)
        if fraction is not None:
            set_progress(self._progress, fraction)

    def show_units(self) -> None:
        """Let what was measured be told in the unit of lengths chosen."""
        self.units_shown.emit()

    def show_measure(self, text: str) -> None:
        """The read-out under Measure, rich text; an invitation when empty."""
        self._reading.setText(text or tr("Click two points of the solid."))
        self._reading.setVisible(self.measuring)

    # ---- parts ---------------------------------------------------------------------------------------

    def _make_state(self) -> QVBoxLayout:
        self._lamp = Dot()
        self._state = QLabel()
        self._state.setWordWrap(True)
        self._state.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self._build = QPushButton(tr("Build"))
        self._build.setToolTip(tr("Build the solid of the design as it is now"))
        self._build.clicked.connect(self.build_requested)
        self._progress = QProgressBar(maximum=1000)
        self._progress.setTextVisible(False)
        self.automatic = QCheckBox(tr("Rebuild when the design changes"))
        self.automatic.setToolTip(tr("Build the solids anew after every edit"))
        self.automatic.setChecked(True)
        self.automatic.toggled.connect(self.automatic_switched)
        made = QVBoxLayout()
        made.setSpacing(7)
        row = QHBoxLayout()
        row.setSpacing(6)
        row.addWidget(self._lamp)
        row.addWidget(self._state, 1)
        row.addWidget(self._build)
        made.addLayout(row)
        made.addWidget(self._progress)
        made.addWidget(self.automatic)
        self.construction = QComboBox()
        self.construction.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.construction.setMinimumContentsLength(10)
        self.construction.setAccessibleName(tr("Construction"))
        self.construction.setToolTip(tr("Faces joined into one shell, or tooth spaces cut from the blank by Booleans"))
        for name, title in CONSTRUCTION_TITLES.items():
            self.construction.addItem(tr(title), name)
        self.construction.currentIndexChanged.connect(
            lambda _index: self.construction_chosen.emit(self.construction.currentData())
        )
        made.addWidget(self.construction)
        return made

    def _make_looks(self) -> QVBoxLayout:
        self._edges = QCheckBox(tr("Edges"))
        self._edges.setToolTip(tr("Draw the edges of the faces"))
        self._edges.setChecked(True)
        self._deviation = QCheckBox(tr("Flanks coloured by deviation"))
        self._deviation.setToolTip(tr("Signed normal deviation of the solid's flanks from theory"))
        made = _heading(tr("Show"))
        for box in (self._edges, self._deviation):
            box.toggled.connect(self.looks_changed)
            made.addWidget(box)
        return made

    def _make_measure(self) -> QVBoxLayout:
        self._measure = QCheckBox(tr("Measure"))
        self._measure.setToolTip(tr("Click two points: their distance and what lies between"))
        self._measure.toggled.connect(self._on_measure)
        self.snapping = QCheckBox(tr("Snap to corners and middles of edges"), checked=True)
        self.snapping.setToolTip(
            tr("A square marks a corner or the middle of an edge near by; a click takes that point")
        )
        self.snapping.hide()
        self._reading = QLabel()
        self._reading.setWordWrap(True)
        self._reading.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._reading.hide()
        made = QVBoxLayout()
        made.setSpacing(4)
        made.addWidget(self._measure)
        made.addWidget(self.snapping)
        made.addWidget(self._reading)
        return made

    def _on_measure(self, on: bool) -> None:
        self.show_measure("")
        self.snapping.setVisible(on)
        self.measure_switched.emit(on)


def _heading(text: str) -> QVBoxLayout:
    label = QLabel(text)
    label.setProperty("role", "heading")
    made = QVBoxLayout()
    made.setSpacing(6)
    made.addSpacing(2)
    made.addWidget(label)
    return made
