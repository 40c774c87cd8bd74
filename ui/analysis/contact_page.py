"""The tooth contact: pattern on both flanks, transmission error, and how misalignments change them."""

from __future__ import annotations

from dataclasses import replace
from html import escape

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QHBoxLayout, QLabel, QScrollArea, QSplitter, QVBoxLayout, QWidget

from gearstudio.analysis.contact_result import Direction
from gearstudio.errors import Issue
from gearstudio.theory.cones import PairGeometry
from ui.analysis.background import Newest
from ui.analysis.contact_controls import WIDTH, ContactControls
from ui.analysis.contact_view import NO_MATE, error_chart, facts, pattern_table
from ui.analysis.contact_work import Case, ContactView, Shown, analyse
from ui.analysis.ease_off_view import ease_off_data, ease_off_facts, ease_off_words
from ui.charts.chart import Chart
from ui.charts.colors import chart_color
from ui.charts.frame import ChartFrame
from ui.charts.map_chart import MapChart
from ui.charts.maps import FlankMap, Line, MapData
from ui.formatting import significant
from ui.method_bar import Segments
from ui.session import Session
from ui.theme import tokens
from ui.words import told, tr

BANDS = 6


class ContactPage(QWidget):
    """Controls on the left, pattern and transmission error beside them; the newest request is computed.

    Signals
    -------
    said(str, str)
    """

    said = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.controls = ContactControls()
        self.maps, self.error = MapChart(), Chart()
        self.pattern_frame = ChartFrame(self.maps)
        self.shown = Segments(
            (
                ("pattern", tr("Contact pattern"), tr("Where the marking compound is wiped off")),
                ("ease_off", tr("Ease-off"), tr("Gap between the flanks beyond that at the mean point, with contours")),
            ),
            tr("Map"),
        )
        self.pattern_frame.add_control(self.shown)
        self.error_frame = ChartFrame(self.error, tr("Transmission error"))
        self.facts, self.warning = QLabel(), QLabel()
        self.facts.setTextFormat(Qt.TextFormat.RichText)
        self.facts.setContentsMargins(12, 0, 8, 0)
        self.facts.setWordWrap(True)
        self.warning.setWordWrap(True)
        self.warning.setContentsMargins(12, 2, 8, 6)
        self.work = Newest("contact analysis", self)
        self._pair: PairGeometry | None = None
        self._reference: PairGeometry | None = None
        self._view: ContactView | None = None
        self._side: Direction = "drive"
        self._shown: Shown = "pattern"
        self._hint = ""
        self.shown.set_choice(self._shown)
        self._arrange()
        self.controls.changed.connect(self._request)
        self.controls.side_chosen.connect(self._choose_side)
        self.shown.chosen.connect(self.show_map)
        self.work.done.connect(self._on_done)
        self.work.failed.connect(self._on_failed)
        self.maps.pointed.connect(lambda text: self.pattern_frame.set_hint(text or self._hint))
        for frame in (self.pattern_frame, self.error_frame):
            frame.said.connect(self.said)

    @property
    def view(self) -> ContactView | None:
        """What is shown."""
        return self._view

    def show_session(self, session: Session) -> None:
        """Analyse the session's pair, when it is another one."""
        if session.pair is None or session.pair is self._pair:
            return
        self._pair = session.pair
        self._reference = replace(session.pair, own_cone_pinion=True)
        self.controls.set_offset(session.pair.has_offset)
        self.controls.set_module(session.pair.wheel.module)
        self._request()

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        self.maps.refresh_theme()
        self.error.refresh_theme()
        self._fill()

    def show_units(self) -> None:
        """Show lengths in the unit chosen."""
        self._fill()

    def close_page(self) -> None:
        """End the background work."""
        self.work.close()

    def _arrange(self) -> None:
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(self.controls)
        column.addWidget(self.facts)
        column.addWidget(self.warning)
        column.addStretch(1)
        left.setProperty("role", "page")
        scroll = QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setProperty("role", "stop")
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scroll.setWidget(left)
        scroll.setFixedWidth(WIDTH + 12)
        scroll.setAccessibleName(tr("What the contact is computed for, and its numbers"))
        charts = QSplitter(Qt.Orientation.Horizontal)
        charts.addWidget(self.pattern_frame)
        charts.addWidget(self.error_frame)
        charts.setChildrenCollapsible(False)
        charts.setSizes([480, 420])
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(scroll)
        layout.addWidget(charts, 1)

    def show_map(self, shown: Shown) -> None:
        """The contact pattern, or the ease-off."""
        self._shown = shown
        self.shown.set_choice(shown)
        self._request()

    def _request(self) -> None:
        if self._pair is None or self._reference is None:
            return
        controls = self.controls
        pair = self._reference if controls.own_cone else self._pair
        case = Case(pair, controls.misalignment, controls.thickness_um, controls.sliding)
        side, shown, known = self._side, self._shown, self._view
        self.work.request(self._pair, lambda: analyse(case, side, shown, known))

    def _choose_side(self, side: Direction) -> None:
        self._side = side
        self._request()

    def _on_done(self, pair: object, view: ContactView) -> None:
        if pair is self._pair:
            self._view = view
            self._fill()

    def _on_failed(self, pair: object, text: str, _details: str) -> None:
        if pair is self._pair:
            self._view = None
            self._hint = ""
            self.facts.setText("")
            self._warn(told(text), "error")
            self.maps.show_data(MapData("contact-pattern"))
            self.pattern_frame.set_hint("")
            self.error.show_data(replace(self.error.data, series=(), references=(), note=tr("No contact")))

    def _fill(self) -> None:
        view = self._view
        if view is None:
            return
        side = view.result.direction(view.side)
        self._hint = ease_off_words(view.ease_off) if view.ease_off is not None else ""
        self.maps.show_data(_pattern_data(view) if view.ease_off is None else ease_off_data(view.ease_off, side))
        self.pattern_frame.set_hint(self._hint)
        self.error.show_data(error_chart(side))
        known = facts(view.result, view.side)
        if view.ease_off is not None:
            known = (*known, *ease_off_facts(view.ease_off))
        cells = [_fact(name, value) for name, value in known]
        rows = (f"<tr>{''.join(cells[start : start + 2])}</tr>" for start in range(0, len(cells), 2))
        self.facts.setText(f'<table cellspacing="0" cellpadding="1">{"".join(rows)}</table>')
        self._warn("\n".join(told(issue.message) for issue in _of_side(view)), "warning")

    def _warn(self, text: str, severity: str) -> None:
        self.warning.setText(text)
        if self.warning.property("severity") != severity:
            self.warning.setProperty("severity", severity)
            self.warning.style().polish(self.warning)


def _pattern_data(view: ContactView) -> MapData:
    side, thickness = view.result.direction(view.side), view.case.thickness_um
    return MapData(
        f"contact-pattern-{view.side}",
        tuple(
            FlankMap(one.title, one.image, one.extent, one.outline, _path(one.path), _gap)
            for one in view.patterns or ()
        ),
        lambda gap: pattern_colors(gap, thickness),
        table=lambda: pattern_table(side),
    )


def _fact(name: str, value: str) -> str:
    muted = tokens().muted
    return f'<td style="color:{muted}">{name}&nbsp;</td><td><b>{escape(value)}</b>&nbsp;&nbsp;</td>'


def pattern_colors(gap_um: NDArray[np.float64], thickness_um: float) -> NDArray[np.uint8]:
    """Where the compound is wiped off in bands, the darker the closer; elsewhere the bare flank, RGBA."""
    bare, pattern = chart_color("hover"), chart_color("pattern")
    with np.errstate(invalid="ignore"):
        share = np.ceil(np.clip(gap_um / thickness_um, 0, 1) * BANDS) / BANDS
        inside = gap_um <= thickness_um
    strength = np.where(inside, 1.0 - 0.7 * np.nan_to_num(share), 0.0)[..., None]
    mixed = _rgb(bare) * (1 - strength) + _rgb(pattern) * strength
    alpha = np.where(np.isnan(gap_um), 0.0, 255.0)[..., None]
    return np.rint(np.concatenate([mixed, alpha], axis=-1)).astype(np.uint8)


def _rgb(color: QColor) -> NDArray[np.float64]:
    return np.array([color.red(), color.green(), color.blue()], dtype=np.float64)


def _path(points: NDArray[np.float64]) -> tuple[Line, ...]:
    return (Line(points, "path"),) if len(points) > 1 else ()


def _gap(value: float) -> str:
    return tr("gap {value} µm", value=significant(value)) if value < 0.5 * NO_MATE else tr("the mate has no flank here")


def _of_side(view: ContactView) -> list[Issue]:
    return [one for one in view.result.warnings if one.message.startswith(view.side) or one.code == "jammed"]
