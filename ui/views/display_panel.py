"""The panel "Display" beside the views: what colours the flanks, surface quality, cameras and ground."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.card import UprightScroll
from ui.theme import set_icon
from ui.views.appearance import STEPS, Appearance
from ui.views.factors import factor_rows
from ui.views.quantities import CURVATURES
from ui.views.quiet import QuietChoice, QuietSlider
from ui.views.zebra import FEWEST, MOST
from ui.words import tr

WIDTH = 252
_COMB_STEPS = 10
"""Slider steps in a factor of ten of the combs' scale."""


class DisplayPanel(QFrame):
    """Shows an `Appearance` and announces every change as a new one.

    Signals
    -------
    changed(object)
        The appearance that the user wants now.
    close_wanted()
    """

    changed = Signal(object)
    close_wanted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._appearance = Appearance()
        self._choices: dict[str, QuietChoice] = {}
        self._boxes: dict[str, QCheckBox] = {}
        self.setObjectName("display_panel")
        self.setAccessibleName(tr("Display"))
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        page = QWidget()
        page.setProperty("role", "page")
        self._form = QFormLayout(page)
        self._form.setContentsMargins(10, 2, 10, 8)
        self._form.setHorizontalSpacing(8)
        self._form.setVerticalSpacing(5)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._fill_colors()
        self._fill_quality()
        self._fill_view()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(1, 4, 1, 4)
        layout.setSpacing(0)
        layout.addLayout(self._header())
        layout.addWidget(UprightScroll(page, WIDTH), 1)
        self.show_appearance(self._appearance)

    def show_appearance(self, appearance: Appearance) -> None:
        """Show a record without announcing it."""
        self._appearance = appearance
        for name, choice in self._choices.items():
            choice.show_choice(getattr(appearance, name))
        for name, box in self._boxes.items():
            with QSignalBlocker(box):
                box.setChecked(getattr(appearance, name))
        self._with_gear.show_choice(appearance.stripes.with_gear)
        self._count.show_value(appearance.stripes.count)
        self._angle.show_value(round(appearance.stripes.angle_deg))
        self._comb_scale.show_value(_comb_step(appearance.comb_scale))
        deviation = appearance.quantity == "deviation"
        self._form.setRowVisible(self._choices["against"], not deviation)
        self._form.setRowVisible(self._choices["unit"], deviation)
        for widget in (self._count, self._with_gear, self._angle):
            self._form.setRowVisible(widget, appearance.zebra)

    # ---- rows ------------------------------------------------------------------------------------------

    def _header(self) -> QHBoxLayout:
        title = QLabel(tr("Display"))
        title.setProperty("role", "heading")
        reset = QPushButton(tr("Reset"))
        reset.setProperty("role", "flat")
        reset.setToolTip(tr("Show everything as in a new window; layers keep their colours"))
        reset.clicked.connect(lambda: self._announce(Appearance(looks=self._appearance.looks)))
        close = QToolButton()
        close.setAutoRaise(True)
        close.setProperty("role", "gutter")
        close.setToolTip(tr("Close"))
        close.setAccessibleName(tr("Close the display panel"))
        set_icon(close, "close")
        close.clicked.connect(self.close_wanted)
        row = QHBoxLayout()
        row.setContentsMargins(10, 0, 6, 2)
        row.addWidget(title, 1)
        row.addWidget(reset)
        row.addWidget(close)
        return row

    def _fill_colors(self) -> None:
        self._section(tr("Flank colours"))
        quantities = [("deviation", tr("Deviation")), *((name, tr(title)) for name, title, _ in CURVATURES)]
        self._choose("quantity", tr("Show"), quantities, tr("What colours the CAD flanks"))
        against = [("", tr("As it is")), ("absolute", tr("Less theory")), ("relative", tr("Less theory, in %"))]
        self._choose("against", tr("Curvature"), against, tr("Curvature itself, or its difference to the exact flank"))
        colors = [
            ("auto", tr("Automatic")),
            ("balance", tr("Blue – orange")),
            ("purple_green", tr("Purple – green")),
            ("dusk", tr("Dark – bright")),
            ("grey", tr("Greys")),
        ]
        self._choose("colors", tr("Colours"), colors, tr("All can be told apart by colour-blind eyes"))
        steps = [(count, tr("Smooth") if count == 0 else tr("{count} steps", count=count)) for count in STEPS]
        self._choose("steps", tr("Steps"), steps, tr("How many colours"))
        units = [("auto", tr("Automatic")), ("um", "µm"), ("nm", "nm"), ("uin", "µin")]
        self._choose("unit", tr("Unit"), units, tr("Unit of deviations on the colour scale and in the views"))
        tip = tr("Draw the CAD flanks with their deviation so many times as large, along the normal")
        self._choose("exaggeration", tr("Exaggerate"), factor_rows(), tip)
        self._box("contours", tr("Contour lines"), tr("Lines of equal value at the marks of the colour scale"))

    def _fill_quality(self) -> None:
        self._section(tr("Surface quality"))
        self._box("zebra", tr("Zebra stripes"), tr("Reflections of straight lamps in the CAD flanks"))
        self._count = QuietSlider(FEWEST, MOST, "{}", tr("Number of stripes"), tr("Number of stripes"))
        self._count.moved.connect(lambda n: self._announce_stripes(count=n))
        self._form.addRow(tr("Stripes"), self._count)
        lamps = [(False, tr("With the camera")), (True, tr("With the gear"))]
        self._with_gear = QuietChoice(lamps, tr("Lamps"), tr("What the lamps are fixed to"))
        self._with_gear.chosen.connect(lambda fixed: self._announce_stripes(with_gear=fixed))
        self._form.addRow(tr("Lamps"), self._with_gear)
        self._angle = QuietSlider(0, 180, "{}°", tr("Direction of the lamps"), tr("Turns the lamps"))
        self._angle.moved.connect(lambda angle: self._announce_stripes(angle_deg=float(angle)))
        self._form.addRow(tr("Direction"), self._angle)
        rows = [("profile", tr("Along the profile")), ("lengthwise", tr("Lengthwise"))]
        tip = tr("Direction of the curvature combs; the layer list switches them on")
        self._choose("combs", tr("Combs"), rows, tip)
        tip = tr("Length of the combs; teeth longer than three typical ones are cut off")
        self._comb_scale = QuietSlider(-_COMB_STEPS, _COMB_STEPS, "", tr("Scale of the combs"), tip)
        self._comb_scale.moved.connect(lambda n: self._announce_one("comb_scale", 10.0 ** (n / _COMB_STEPS)))
        self._form.addRow(tr("Length"), self._comb_scale)

    def _fill_view(self) -> None:
        self._section(tr("Views"))
        rows = [(False, tr("Perspective")), (True, tr("Parallel"))]
        self._choose("parallel", tr("Projection"), rows, tr("Parallel shows true proportions"))
        self._box("linked", tr("One camera for all"), tr("Turn the views together, or each by itself"))
        grounds = [
            ("theme", tr("As the theme")),
            ("white", tr("White")),
            ("grey", tr("Grey")),
            ("black", tr("Black")),
        ]
        self._choose("ground", tr("Ground"), grounds, tr("Background of the views"))
        self._box("axes", tr("Axes"), tr("Directions x, y and z of the gear"))
        self._box("scale_bar", tr("Scale bar"), tr("A round length; in perspective, of what is in the middle"))
        self._box("edges", tr("Edges"), tr("Borders of the flanks"))

    def _section(self, title: str) -> None:
        label = QLabel(title)
        label.setProperty("role", "section")
        label.setContentsMargins(0, 6, 0, 0)
        self._form.addRow(label)

    def _choose(self, name: str, title: str, rows: list[Any], tip: str) -> None:
        choice = self._choices[name] = QuietChoice(rows, title, tip)
        choice.chosen.connect(lambda value: self._announce_one(name, value))
        self._form.addRow(title, choice)

    def _box(self, name: str, title: str, tip: str) -> None:
        box = self._boxes[name] = QCheckBox(title)
        box.setToolTip(tip)
        box.toggled.connect(lambda on: self._announce_one(name, on))
        self._form.addRow(box)

    # ---- changes ---------------------------------------------------------------------------------------

    def _announce_stripes(self, **changes: Any) -> None:
        self._announce_one("stripes", replace(self._appearance.stripes, **changes))

    def _announce_one(self, name: str, value: Any) -> None:
        self._announce(replace(self._appearance, **{name: value}))

    def _announce(self, appearance: Appearance) -> None:
        self.show_appearance(appearance)
        self.changed.emit(appearance)


def _comb_step(scale: float) -> int:
    return round(_COMB_STEPS * math.log10(scale))
