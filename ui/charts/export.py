"""Charts as pictures and tables: PNG, SVG and CSV, to a file or the clipboard."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QMimeData, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtSvg import QSvgGenerator
from PySide6.QtWidgets import QGraphicsItem, QGraphicsView

from gearstudio.errors import FileError
from gearstudio.files import write_bytes
from ui.words import noted

FILTERS = noted("Picture (*.png);;Drawing (*.svg);;Table (*.csv)")
SUFFIXES = (".png", ".svg", ".csv")
SCALE = 2.0
"""A saved picture has this many pixels for one on the screen."""
Paint = Callable[[QPainter, QRectF], None]


def scene_paint(view: QGraphicsView, ground: Callable[[], QColor]) -> Paint:
    """A function that draws a graphics view as it is, on a ground, into any painter."""

    def draw(painter: QPainter, area: QRectF) -> None:
        painter.fillRect(area, ground())
        view.scene().prepareForPaint()  # type: ignore[attr-defined]
        with _drawn_afresh(view):
            view.render(painter, area, view.viewport().rect(), Qt.AspectRatioMode.IgnoreAspectRatio)

    return draw


@contextmanager
def _drawn_afresh(view: QGraphicsView) -> Iterator[None]:
    """Items draw lines and letters instead of the pictures of themselves that they keep for the screen."""
    cached = [(item, item.cacheMode()) for item in view.scene().items()]
    kept = [(item, mode) for item, mode in cached if mode != QGraphicsItem.CacheMode.NoCache]
    dots = [item for item, _ in cached if hasattr(item, "setExportMode")]
    for item, _ in kept:
        item.setCacheMode(QGraphicsItem.CacheMode.NoCache)
    for item in dots:
        item.setExportMode(True, {"antialias": True, "resolutionScale": 1.0})
    try:
        yield
    finally:
        for item in dots:
            item.setExportMode(False)
        for item, mode in kept:
            item.setCacheMode(mode)


def picture(size: QSize, paint: Paint) -> QImage:
    """What ``paint`` draws, at double resolution."""
    image = QImage(size * SCALE, QImage.Format.Format_ARGB32)
    image.setDevicePixelRatio(SCALE)
    image.fill(0)
    painter = QPainter(image)
    painter.setRenderHints(QPainter.RenderHint.Antialiasing | QPainter.RenderHint.TextAntialiasing)
    paint(painter, QRectF(0, 0, size.width(), size.height()))
    painter.end()
    return image


def svg_bytes(size: QSize, paint: Paint, title: str) -> bytes:
    """What ``paint`` draws as an SVG document."""
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    generator = QSvgGenerator()
    generator.setOutputDevice(buffer)
    generator.setSize(size)
    generator.setViewBox(QRect(0, 0, size.width(), size.height()))
    generator.setTitle(title)
    painter = QPainter(generator)
    paint(painter, QRectF(0, 0, size.width(), size.height()))
    painter.end()
    buffer.close()
    return bytes(data.data())


def png_bytes(image: QImage) -> bytes:
    """A picture as a PNG file."""
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")
    return bytes(data.data())


def save(path: Path, size: QSize, paint: Paint, csv_text: str, title: str) -> Path:
    """Write a chart in the format that the name asks for; PNG when it has no ending.

    Raises
    ------
    FileError
        The ending is none of SUFFIXES, or the file cannot be written.
    """
    path = path if path.suffix else path.with_name(path.name + ".png")
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise FileError(path, f"a chart is saved as {', '.join(SUFFIXES)}, not as {suffix}")
    if suffix == ".png":
        data = png_bytes(picture(size, paint))
    else:
        data = svg_bytes(size, paint, title) if suffix == ".svg" else csv_text.encode()
    write_bytes(path, data)
    return path


def clipboard_data(size: QSize, paint: Paint, text: str, what: str = "both") -> QMimeData:
    """Picture and table together (a text editor takes the numbers, a document the picture), or one of them."""
    data = QMimeData()
    if what != "numbers":
        data.setImageData(picture(size, paint))
    if what != "picture":
        data.setText(text)
    return data
