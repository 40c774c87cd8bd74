"""Measured points on the gear in 3D: a view of its own, made when it is first looked at."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QHBoxLayout, QWidget

from gearstudio.theory.cones import MemberGeometry
from ui.charts.export import Paint
from ui.charts.records import Table
from ui.presenter import exaggerated_words
from ui.theme import is_dark
from ui.views.factors import AUTOMATIC, OFF
from ui.words import tr

if TYPE_CHECKING:
    from ui.color_bar import ColorBar
    from ui.layers import Layer
    from ui.view_grid import ViewGrid

NAME = "measured-points"


class MeasuredView(QWidget):
    """Points and nets on the gear in grey, with their own colour scale."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.grid: ViewGrid | None = None
        self.bar: ColorBar | None = None
        self.numbers: Callable[[], Table] = lambda: Table((), ())
        self._waiting: tuple[MemberGeometry, tuple[Layer, ...], str, float] | None = None
        self._shown = self._waiting
        self._closed = False
        self.exaggeration = OFF
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(0)

    @property
    def name(self) -> str:
        """For file names."""
        return NAME

    @property
    def table(self) -> Table:
        """The points."""
        return self.numbers()

    @property
    def paint(self) -> Paint:
        """A function that draws the picture into any painter."""
        picture = self.grab()

        def draw(painter: QPainter, area: QRectF) -> None:
            painter.drawPixmap(area, picture, QRectF(picture.rect()))

        return draw

    def show_points(self, member: MemberGeometry, layers: Sequence[Layer], title: str, largest_um: float) -> None:
        """Show layers of `measured_scene`; drawn at once when in sight, else when it comes in sight."""
        self._waiting = member, tuple(layers), title, largest_um
        if self.isVisible():
            self._draw()

    def exaggerate(self, wanted: int) -> None:
        """Draw deviations so many times as large, along the normal; `factors.AUTOMATIC` for what suits them."""
        self.exaggeration, self._waiting = wanted, self._waiting or self._shown
        if self.isVisible():
            self._draw()

    def clear(self) -> None:
        """Show nothing."""
        self._waiting = self._shown = None
        if self.grid is not None:
            self.grid.set_panels(())

    def refresh_theme(self) -> None:
        """Take the colours of the theme in use."""
        if self.grid is not None:
            self.grid.set_theme(is_dark())

    def close_view(self) -> None:
        """Let go of the renderer."""
        self._closed = True
        if self.grid is not None:
            self.grid.close_views()

    def showEvent(self, event: object) -> None:
        super().showEvent(event)  # type: ignore[arg-type]
        self._draw()

    def _draw(self) -> None:
        if self._waiting is None or self._closed:
            return
        from ui.layers import Panel
        from ui.scene import member_layers
        from ui.views.exaggeration import stretched, suitable

        member, layers, title, largest = self._shown = self._waiting
        self._waiting = None
        grid, bar = self._made()
        factor = self.exaggeration
        if factor == AUTOMATIC:
            factor = suitable(member.addendum + member.dedendum, largest)
        drawn = stretched(layers, factor)
        words = exaggerated_words(title, factor)
        grid.set_panels((Panel(NAME, tr("Measured points"), words, (*member_layers(member), *drawn)),))
        bar.show_exaggeration(factor)
        bar.set_data_limit(largest)
        self._color(*bar.range)

    def _color(self, low: float, high: float) -> None:
        if self.grid is not None:
            self.grid.set_color_range(high, low)

    def _made(self) -> tuple[ViewGrid, ColorBar]:
        if self.grid is None or self.bar is None:
            from ui.color_bar import ColorBar
            from ui.view_grid import ViewGrid

            self.grid, self.bar = ViewGrid(self), ColorBar(self)
            self.bar.range_changed.connect(self._color)
            self._row.addWidget(self.grid, 1)
            self._row.addWidget(self.bar)
            self.grid.set_theme(is_dark())
        return self.grid, self.bar
