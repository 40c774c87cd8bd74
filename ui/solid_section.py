"""The section through a solid: switch, axis, place and side of its plane."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QSlider, QToolButton, QVBoxLayout, QWidget

from ui.method_bar import Segments
from ui.theme import set_icon
from ui.units import with_unit
from ui.words import tr

STEPS = 400
AXES = ("x", "y", "z")


class SolidSection(QWidget):
    """Shows where a plane cuts, and announces where it is wanted.

    Signals
    -------
    changed()
        The plane was switched, moved or turned over.
    side_wanted()
        It was switched on or got another axis: `set_side` is to tell the side that is in the way.
    """

    changed = Signal()
    side_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._range, self._place = (-1.0, 1.0), 0.0
        self._axis, self._side = "y", 1
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(5)
        layout.addLayout(self._make_choices())
        layout.addLayout(self._make_slider())
        self._show()

    # ---- what is chosen ------------------------------------------------------------------------------

    @property
    def plane(self) -> tuple[int, float, int] | None:
        """Axis, place [mm] and side taken away, as `section.Plane` takes them; None without a section."""
        if not self.box.isChecked():
            return None
        return self.axis, self._place, -self._side if self._flip.isChecked() else self._side

    @property
    def axis(self) -> int:
        """Axis of the section, whether it is on or not."""
        return AXES.index(self._axis)

    # ---- what is shown -------------------------------------------------------------------------------

    def set_range(self, low: float, high: float) -> None:
        """Lowest and highest place of the section along its axis [mm]; the place stays if it can."""
        if (low, high) != self._range:
            self._range = (low, high)
            self._put(min(max(self._place, low), high))

    def set_axis(self, axis: str, place: float) -> None:
        """Cut square to an axis at a place, without announcing it."""
        self._axis = axis
        self._axes.set_choice(axis)
        self._put(place)

    def set_side(self, side: int) -> None:
        """Side (+1 or -1) to take away while it is not flipped."""
        self._side = side
        with QSignalBlocker(self._flip):
            self._flip.setChecked(False)

    def show_units(self) -> None:
        """Show the place in the unit of lengths chosen."""
        self._where.setText(with_unit(self._place, "mm", 2))

    # ---- parts ---------------------------------------------------------------------------------------

    def _make_choices(self) -> QHBoxLayout:
        self.box = QCheckBox(tr("Section"))
        self.box.setToolTip(tr("Take away what lies beyond a plane and show the cut face"))
        self.box.toggled.connect(self._on_switched)
        self._axes = Segments(
            [(a, a, tr("Cut square to the {axis} axis", axis=a)) for a in AXES], tr("Axis of the section")
        )
        self._axes.set_choice(self._axis)
        self._axes.chosen.connect(self._on_axis)
        self._flip = QToolButton(checkable=True, autoRaise=True)
        self._flip.setToolTip(tr("Take away the other side"))
        self._flip.setAccessibleName(tr("Take away the other side"))
        set_icon(self._flip, "flip")
        self._flip.toggled.connect(self._on_changed)
        row = QHBoxLayout()
        row.setSpacing(6)
        row.addWidget(self.box)
        row.addStretch(1)
        row.addWidget(self._axes)
        row.addWidget(self._flip)
        return row

    def _make_slider(self) -> QHBoxLayout:
        self.slider = QSlider(Qt.Orientation.Horizontal, maximum=STEPS, value=STEPS // 2)
        self.slider.setAccessibleName(tr("Place of the section"))
        self.slider.setToolTip(tr("Where the plane of the section stands"))
        self.slider.valueChanged.connect(self._on_slid)
        self._where = QLabel()
        self._where.setProperty("role", "muted")
        self._where.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._where.setFixedWidth(self._where.fontMetrics().horizontalAdvance("−000.00 mm") + 4)
        row = QHBoxLayout()
        row.setSpacing(6)
        row.addWidget(self.slider, 1)
        row.addWidget(self._where)
        return row

    # ---- changes -------------------------------------------------------------------------------------

    def _put(self, place: float) -> None:
        low, high = self._range
        self._place = place
        with QSignalBlocker(self.slider):
            self.slider.setValue(round(STEPS * (place - low) / max(high - low, 1e-12)))
        self._show()

    def _on_axis(self, axis: str) -> None:
        self._axis = axis
        with QSignalBlocker(self.box):
            self.box.setChecked(True)
        self._on_switched()

    def _on_switched(self) -> None:
        self.side_wanted.emit()
        self._on_changed()

    def _on_slid(self, value: int) -> None:
        low, high = self._range
        self._place = low + value / STEPS * (high - low)
        self._on_changed()

    def _on_changed(self) -> None:
        self._show()
        self.changed.emit()

    def _show(self) -> None:
        for widget in (self.slider, self._flip, self._where):
            widget.setEnabled(self.box.isChecked())
        self.show_units()
