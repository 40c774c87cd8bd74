"""Pictures of the views at any scale: the scene in tiles, everything in type painted over it at full sharpness."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass

from PySide6.QtCore import QPoint, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QLinearGradient, QPainter
from PySide6.QtWidgets import QWidget

from ui.theme import DARK, LIGHT
from ui.view_grid import ViewGrid
from ui.views.color_scale import ColorScale
from ui.views.panes import Tile
from ui.views.still import StillViewport

SMOOTHING = 2
"""The scene is drawn so many times finer, each way, than the picture."""
Steps = Generator[float, None, QImage]


@dataclass(frozen=True)
class PictureOptions:
    """How a picture of the views is taken.

    Attributes
    ----------
    scale : int
        Pixels of the picture for a pixel of its layout.
    transparent : bool
        Clear where nothing is.
    labels, scale_bar : bool
        With titles, axes and scale; with the colour scale.
    """

    scale: int = 1
    transparent: bool = False
    labels: bool = True
    scale_bar: bool = True


def stand_in(grid: ViewGrid, size: QSize) -> ViewGrid:
    """A view grid of another size that shows the same into pictures; it must be closed by `ViewGrid.close_views`."""
    made = ViewGrid(make_viewport=StillViewport)
    lay_out(made, size)
    made.set_theme(grid.dark)
    made.show_appearance(grid.appearance)
    low, high = grid.color_range
    made.set_visible_layers(grid.visible_layers)
    made.set_panels(grid.panels)
    made.set_color_range(high, low)
    made.store.stand_like(grid.store)
    made.viewport.looks = list(grid.viewport.looks)
    made.pointing.pin, made.pointing.pin_place = grid.pointing.pin, grid.pointing.pin_place
    made.follow_cameras()
    return made


def lay_out(grid: ViewGrid, size: QSize) -> None:
    """Give a grid that is not shown its size."""
    grid.resize(size)
    grid.viewport.resize(size)
    grid.place_overlays()


def painted(grid: ViewGrid, bar: ColorScale | None, options: PictureOptions) -> Steps:
    """Paint a stand-in, tile by tile; yields how far it is and returns the picture.

    Parameters
    ----------
    grid : ViewGrid
        With a `StillViewport`; its size is that of the layout, without the colour scale.
    bar : ColorScale or None
        The colour scale to put to the right.
    options : PictureOptions

    Raises
    ------
    RuntimeError
        OpenGL does not draw here.
    """
    viewport = grid.viewport
    assert isinstance(viewport, StillViewport)
    size, scale = grid.size(), options.scale
    side = picture_bar(bar, size.height(), grid.dark) if bar is not None and options.scale_bar else None
    width = size.width() + (side.width() if side is not None else 0)
    image = QImage(width * scale, size.height() * scale, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    try:
        yield from _paint(painter, grid, viewport, side, options)
    finally:
        painter.end()  # before the picture may go, also when the rest is given up
        if side is not None:
            side.deleteLater()
    return image


def _paint(
    painter: QPainter, grid: ViewGrid, viewport: StillViewport, side: ColorScale | None, options: PictureOptions
) -> Generator[float, None, None]:
    size, scale = grid.size(), options.scale
    painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform)
    painter.scale(scale, scale)
    if not options.transparent:
        _paint_ground(painter, grid, size)
    count = scale * SMOOTHING
    grid.store.restyle(grid.store.dark, float(count))
    for index in range(count * count):
        column, row = index % count, index // count
        tile = viewport.picture(size, Tile(count, column, row))
        _paint_tile(painter, tile, viewport.pane_count, (column, count - 1 - row), count, size * scale)
        yield (index + 1) / (count * count)
    if options.labels:
        for overlay in grid.overlays.in_pictures:
            if overlay.isVisibleTo(grid):
                _paint_widget(painter, overlay, overlay.pos())
    if side is not None:
        if not options.transparent:
            back = QColor((DARK if grid.dark else LIGHT).surface)
            painter.fillRect(QRectF(size.width(), 0, side.width(), size.height()), back)
        _paint_widget(painter, side, QPoint(size.width(), 0))


def at_once(steps: Steps, tell: Callable[[float], object] = lambda done: None) -> QImage:
    """The picture of `painted`, without pauses; ``tell`` takes how far it is.

    Raises
    ------
    RuntimeError
        As `painted`.
    """
    while True:
        try:
            tell(next(steps))
        except StopIteration as end:
            return end.value  # type: ignore[no-any-return]


def picture_bar(bar: ColorScale, height: int, dark: bool) -> ColorScale:
    """A colour scale like another one, for a picture: in letters that suit the picture's ground."""
    made = ColorScale()
    made.setStyleSheet(f"QWidget {{ color: {(DARK if dark else LIGHT).text}; }}")
    made.show_like(bar)
    made.setFixedSize(made.sizeHint().width(), height)
    made.ensurePolished()
    return made


def _paint_ground(painter: QPainter, grid: ViewGrid, size: QSize) -> None:
    top, bottom = grid.ground
    ground = QLinearGradient(0, 0, 0, size.height())
    ground.setColorAt(0, QColor(top))
    ground.setColorAt(1, QColor(bottom))
    painter.fillRect(QRectF(0, 0, size.width(), size.height()), ground)


def _paint_tile(painter: QPainter, tile: QImage, panes: int, place: tuple[int, int], count: int, size: QSize) -> None:
    """Put a tile, which shows the same piece of every pane, where it belongs in a picture of some size in pixels."""
    painter.save()
    painter.resetTransform()
    top, bottom = (round((place[1] + k) * size.height() / count) for k in (0, 1))
    for pane in range(panes):
        left, right = (round(k * tile.width() / panes) for k in (pane, pane + 1))
        start, end = (round(k * size.width() / panes) for k in (pane, pane + 1))
        near, far = (start + round((place[0] + k) * (end - start) / count) for k in (0, 1))
        piece = tile.copy(left, 0, right - left, tile.height()).scaled(
            far - near, bottom - top, Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation
        )
        painter.drawImage(near, top, piece)
    painter.restore()


def _paint_widget(painter: QPainter, widget: QWidget, place: QPoint) -> None:
    painter.save()
    painter.translate(place)
    widget.render(painter, QPoint(0, 0), renderFlags=QWidget.RenderFlag.DrawChildren)
    painter.restore()
