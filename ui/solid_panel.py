"""What a solid is and how it is shown: state and build, edges, deviation, section, measuring, material, properties."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QSizePolicy,
    QSlider,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.card import ScrollCard
from ui.formatting import CONSTRUCTION_TITLES
from ui.method_bar import Segments
from ui.progress import set_progress
from ui.properties_table import PropertiesTable
from ui.status import Dot
from ui.theme import set_icon
from ui.units import with_unit
from ui.words import tr

STEPS = 400
AXES = ("x", "y", "z")


class SolidPanel(QWidget):
    """Shows what it is told and announces what is chosen.

    Signals
    -------
    build_requested()
    construction_chosen(str)
    automatic_switched(bool)
    looks_changed()
        Edges or deviation.
    section_changed()
        The section plane was switched, moved or turned over.
    section_side_wanted()
        The section was switched on or got another axis: `set_section_side` is to tell the side that is in the way.
    measure_switched(bool)
    units_shown()
        Lengths are to be shown in another unit.
    """

    build_requested = Signal()
    construction_chosen = Signal(str)
    automatic_switched = Signal(bool)
    looks_changed = Signal()
    section_changed = Signal()
    section_side_wanted = Signal()
    measure_switched = Signal(bool)
    units_shown = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._range, self._place = (-1.0, 1.0), 0.0
        self._axis, self._side = "y", 1
        card = ScrollCard((12, 10, 10, 8))
        rows = card.rows
        for part in (self._make_state(), self._make_looks(), self._make_section(), self._make_measure()):
            rows.addLayout(part)
        self.properties = PropertiesTable()
        rows.addSpacing(4)
        rows.addWidget(self.properties)
        rows.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2, 0, 8, 4)
        layout.addWidget(card)
        self.setMinimumWidth(262)
        self.show_state(tr("Not built yet"), "muted", None)
        self._show_section()

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
    def section(self) -> tuple[int, float, int] | None:
        """Axis, place [mm] and side taken away, as `section.Plane` takes them; None without a section."""
        if not self.section_box.isChecked():
            return None
        return self.axis, self._place, -self._side if self._flip.isChecked() else self._side

    @property
    def axis(self) -> int:
        """Axis of the section, whether it is on or not."""
        return AXES.index(self._axis)

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

    def set_section_range(self, low: float, high: float) -> None:
        """Lowest and highest place of the section along its axis [mm]; the place stays if it can."""
        if (low, high) != self._range:
            self._range = (low, high)
            self._put(min(max(self._place, low), high))

    def set_section_axis(self, axis: str, place: float) -> None:
        """Cut square to an axis at a place, without announcing it."""
        self._axis = axis
        self._axes.set_choice(axis)
        self._put(place)

    def set_section_side(self, side: int) -> None:
        """Side (+1 or -1) to take away while it is not flipped."""
        self._side = side
        with QSignalBlocker(self._flip):
            self._flip.setChecked(False)

    def show_units(self) -> None:
        """Show lengths in the unit chosen."""
        self._show_section()
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
        made.addLayout(_row(self._lamp, self._state, self._build, stretch=1))
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

    def _make_section(self) -> QVBoxLayout:
        self.section_box = QCheckBox(tr("Section"))
        self.section_box.setToolTip(tr("Take away what lies beyond a plane and show the cut face"))
        self.section_box.toggled.connect(self._on_switched)
        self._axes = Segments(
            [(a, a, tr("Cut square to the {axis} axis", axis=a)) for a in AXES], tr("Axis of the section")
        )
        self._axes.set_choice(self._axis)
        self._axes.chosen.connect(self._on_axis)
        self._flip = QToolButton(checkable=True, autoRaise=True)
        self._flip.setToolTip(tr("Take away the other side"))
        self._flip.setAccessibleName(tr("Take away the other side"))
        set_icon(self._flip, "flip")
        self._flip.toggled.connect(self._on_section)
        self.section_slider = QSlider(Qt.Orientation.Horizontal, maximum=STEPS, value=STEPS // 2)
        self.section_slider.setAccessibleName(tr("Place of the section"))
        self.section_slider.setToolTip(tr("Where the plane of the section stands"))
        self.section_slider.valueChanged.connect(self._on_slid)
        self._where = QLabel()
        self._where.setProperty("role", "muted")
        self._where.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._where.setFixedWidth(self._where.fontMetrics().horizontalAdvance("−000.00 mm") + 4)
        made = QVBoxLayout()
        made.setSpacing(5)
        made.addLayout(_row(self.section_box, None, self._axes, self._flip))
        made.addLayout(_row(self.section_slider, self._where, stretch=0))
        return made

    def _make_measure(self) -> QVBoxLayout:
        self._measure = QCheckBox(tr("Measure"))
        self._measure.setToolTip(tr("Click two points: their distance and what lies between"))
        self._measure.toggled.connect(self._on_measure)
        self.snapping = QCheckBox(tr("Snap to corners and middles of edges"), checked=True)  # type: ignore[call-arg]
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

    # ---- section -------------------------------------------------------------------------------------

    def _put(self, place: float) -> None:
        low, high = self._range
        self._place = place
        with QSignalBlocker(self.section_slider):
            self.section_slider.setValue(round(STEPS * (place - low) / max(high - low, 1e-12)))
        self._show_section()

    def _on_axis(self, axis: str) -> None:
        self._axis = axis
        with QSignalBlocker(self.section_box):
            self.section_box.setChecked(True)
        self._on_switched()

    def _on_switched(self) -> None:
        self.section_side_wanted.emit()
        self._on_section()

    def _on_slid(self, value: int) -> None:
        low, high = self._range
        self._place = low + value / STEPS * (high - low)
        self._on_section()

    def _on_section(self) -> None:
        self._show_section()
        self.section_changed.emit()

    def _show_section(self) -> None:
        for widget in (self.section_slider, self._flip, self._where):
            widget.setEnabled(self.section_box.isChecked())
        self._where.setText(with_unit(self._place, "mm", 2))

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


def _row(*widgets: QWidget | None, stretch: int | None = None) -> QHBoxLayout:
    """Widgets side by side; None takes the room that is left, or the widget at ``stretch`` does."""
    made = QHBoxLayout()
    made.setSpacing(6)
    for index, widget in enumerate(widgets):
        if widget is None:
            made.addStretch(1)
        else:
            made.addWidget(widget, int(index == stretch))
    return made
