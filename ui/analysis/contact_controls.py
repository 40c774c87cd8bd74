"""What the contact is computed for: misalignments, marking compound, drive or coast."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from gearstudio.analysis.contact_placing import MARKING_THICKNESS_UM, Misalignment
from ui.analysis.number_slider import NumberSlider
from ui.method_bar import Segments
from ui.words import noted, tr

MISALIGNMENTS = (
    ("offset", noted("E  offset"), "Pinion axis beside the wheel's, positive as a positive hypoid offset", "mm"),
    ("pinion_axial", "P  pinion axial", "Pinion along its axis, positive away from the crossing point", "mm"),
    ("wheel_axial", "G  wheel axial", "Wheel along its axis, positive away from the crossing point", "mm"),
    ("shaft_angle_deg", "Σ  shaft angle", "Shaft angle beyond its nominal value", "°"),
)
MODULES_REACHED, DEGREES_REACHED = 0.05, 0.25
THICKEST_UM = 50.0
WIDTH = 312
SIDES = (
    ("drive", "Drive", "The pinion's concave flank leads"),
    ("coast", "Coast", "The pinion's convex flank leads"),
)


PINIONS = (
    ("conjugate", noted("Conjugate"), "The pinion's flanks as the wheel makes them"),
    ("own_cone", noted("Own base cone"), "A reference: the pinion's flanks as involutes on base cones of their own"),
)


class ContactControls(QWidget):
    """Sliders with boxes.

    Signals
    -------
    changed()
        Another misalignment or thickness, or a slider let go.
    side_chosen(str)
        ``"drive"`` or ``"coast"``.
    """

    changed = Signal()
    side_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.sides = Segments(SIDES, tr("Side of the teeth"))
        self.sides.set_choice("drive")
        self.sides.chosen.connect(self.side_chosen)
        reset = QPushButton(tr("Reset"))
        reset.setToolTip(tr("No misalignment, usual marking compound"))
        reset.clicked.connect(self.reset)
        top = QHBoxLayout()
        top.setSpacing(8)
        top.addWidget(self.sides)
        top.addStretch(1)
        top.addWidget(reset)
        self.pinions = Segments(PINIONS, tr("Flanks of the pinion"))
        self.pinions.set_choice(PINIONS[0][0])
        self.pinions.chosen.connect(lambda _choice: self.changed.emit())
        self.pinions.hide()
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(2)
        grid.setColumnStretch(1, 1)
        self.rows = {
            name: NumberSlider(grid, row, tr(label), tr(tip), unit, 3)
            for row, (name, label, tip, unit) in enumerate(MISALIGNMENTS)
        }
        tip = tr("Thickness of the marking compound: where the gap is less, it is wiped off")
        self.thickness = NumberSlider(grid, len(MISALIGNMENTS), tr("Compound"), tip, "µm", 2)
        self.thickness.set_range(0.5, THICKEST_UM, most=1000.0, least=0.01)
        self.thickness.set_value(MARKING_THICKNESS_UM)
        for row in (*self.rows.values(), self.thickness):
            row.changed.connect(lambda _value: self.changed.emit())
            row.slider.sliderReleased.connect(self.changed)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 6, 8, 2)
        layout.setSpacing(5)
        layout.addLayout(top)
        layout.addWidget(self.pinions, 0, Qt.AlignmentFlag.AlignLeft)
        layout.addLayout(grid)
        layout.addStretch(1)
        layout.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.setFixedWidth(WIDTH)

    @property
    def misalignment(self) -> Misalignment:
        """As set."""
        return Misalignment(**{name: row.value for name, row in self.rows.items()})

    @property
    def sliding(self) -> bool:
        """Whether a slider is being moved with the mouse."""
        return any(row.slider.isSliderDown() for row in (*self.rows.values(), self.thickness))

    @property
    def thickness_um(self) -> float:
        """Of the marking compound."""
        return self.thickness.value

    def set_offset(self, has_offset: bool) -> None:
        """Offer the reference pinion where there is an offset, and only there."""
        self.pinions.setVisible(has_offset)
        if not has_offset:
            self.pinions.set_choice(PINIONS[0][0])

    @property
    def own_cone(self) -> bool:
        """Whether the reference pinion is asked for."""
        return not self.pinions.isHidden() and self.pinions.button("own_cone").isChecked()

    def show_units(self) -> None:
        """Show lengths in the unit chosen; what is set stays."""
        for row in (*self.rows.values(), self.thickness):
            row.show_units()

    def set_module(self, module: float) -> None:
        """Sliders that reach as far as makes sense for teeth of this size."""
        reach = MODULES_REACHED * module
        for name, row in self.rows.items():
            if name == "shaft_angle_deg":
                row.set_range(-DEGREES_REACHED, DEGREES_REACHED, most=10.0)
            else:
                row.set_range(-reach, reach, most=10 * module)

    def reset(self) -> None:
        """Back to the perfect pair."""
        before = (self.misalignment, self.thickness_um)
        self.blockSignals(True)
        for row in self.rows.values():
            row.set_value(0.0)
        self.thickness.set_value(MARKING_THICKNESS_UM)
        self.blockSignals(False)
        if before != (self.misalignment, self.thickness_um):
            self.changed.emit()
