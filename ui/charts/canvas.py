"""What charts of curves and maps have in common: the scene they are drawn in, and how it gets into pictures."""

from __future__ import annotations

from PySide6.QtWidgets import QVBoxLayout, QWidget

from ui.charts.colors import chart_color
from ui.charts.export import Paint, scene_paint
from ui.charts.maps import MapData
from ui.charts.menu import QuietView
from ui.charts.records import ChartData


class Canvas(QWidget):
    """A scene that fills the widget."""

    data: ChartData | MapData

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._view = QuietView()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._view)

    @property
    def paint(self) -> Paint:
        """A function that draws what is shown as it is, on the theme's ground, into any painter."""
        return scene_paint(self._view, lambda: chart_color("surface"))

    @property
    def name(self) -> str:
        """For file names."""
        return self.data.name
