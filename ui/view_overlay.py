"""What lies over the views in crisp Qt type: titles, the value under the pointer, its marker, the axes."""

from __future__ import annotations

import math
from html import escape

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QLabel, QWidget

from ui import units
from ui.camera import Camera
from ui.formatting import number
from ui.theme import DARK, LIGHT, Tokens

MARGIN = 10
PLATE_ALPHA = 215
"""Words over the views stand on a plate through which the gear is just seen."""
LEAST_TITLE = 90
"""Narrower panes have no title [pixels]."""
DOT = " · "
"""Between the parts of a title."""
TIMES = "\N{MULTIPLICATION SIGN}"
_PLATE = 14
"""Padding, border and margin at the sides of a title."""


class _Overlay(QWidget):
    """A child of the views that lets the mouse through."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.colors: Tokens = LIGHT

    def set_theme(self, dark: bool) -> None:
        """Take the theme's colours."""
        self.colors = DARK if dark else LIGHT
        self.update()


class PaneTitle(QLabel):
    """Title and subtitle of a pane on a soft plate."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setTextFormat(Qt.TextFormat.RichText)
        self._text = ("", "")
        self._lines: tuple[tuple[str, ...], tuple[str, ...]] = ("",), ("",)
        self._colors = LIGHT

    def set_theme(self, dark: bool) -> None:
        """Take the theme's colours."""
        self._colors = DARK if dark else LIGHT
        red, green, blue, _ = QColor(self._colors.surface).getRgb()
        self.setStyleSheet(
            f"PaneTitle {{ background: rgba({red},{green},{blue},{PLATE_ALPHA}); color: {self._colors.text};"
            f" border: 1px solid {self._colors.border}; border-radius: 7px; padding: 4px 9px; }}"
        )
        self._compose()

    def set_text(self, title: str, subtitle: str) -> None:
        """Show a title and, smaller, what belongs to it."""
        if (title, subtitle) != self._text:
            self._text = (title, subtitle)
            self._lines = (title,), (subtitle,)
            self._compose()

    def fit(self, width: int) -> None:
        """Take the text's own size; where there is not so much room, leave out what matters least."""
        bold = QFont(self.font())
        bold.setWeight(QFont.Weight.DemiBold)
        title, subtitle = self._text
        room = float(width - 2 * _PLATE)
        lines = (
            fitted(title, QFontMetricsF(bold), room, breaks=True),
            fitted(subtitle, QFontMetricsF(self.font()), room),
        )
        if lines != self._lines:
            self._lines = lines
            self._compose()
        self.resize(min(self.sizeHint().width(), width), self.sizeHint().height())

    @property
    def empty(self) -> bool:
        """Whether there is nothing to show."""
        return not any(self._text)

    @property
    def whole(self) -> str:
        """All the words, also those that are left out."""
        return "\n".join(text for text in self._text if text)

    @property
    def shortened(self) -> bool:
        """Whether something is left out."""
        return [DOT.join(lines) for lines in self._lines] != list(self._text)

    def _compose(self) -> None:
        title, subtitle = ("<br>".join(escape(line) for line in lines) for lines in self._lines)
        second = f'<br><span style="color:{self._colors.muted}">{subtitle}</span>' if subtitle else ""
        self.setText(f'<span style="font-weight:600">{title}</span>{second}' if title or subtitle else "")
        self.setAccessibleName(self.whole)
        self.adjustSize()


def fitted(text: str, metrics: QFontMetricsF, room: float, breaks: bool = False) -> tuple[str, ...]:
    """Of a text's parts, which dots join, as many as fit in a line; the first matter most.

    A factor may lose its words. With ``breaks`` the parts that do not fit have a line each.
    """
    parts = text.split(DOT)
    if metrics.horizontalAdvance(text) > room:
        parts = [part[max(part.find(TIMES), 0) :] for part in parts]
    shown = len(parts)
    while shown > 1 and metrics.horizontalAdvance(DOT.join(parts[:shown])) > room:
        shown -= 1
    lines = [DOT.join(parts[:shown]), *(parts[shown:] if breaks else ())]
    return tuple(metrics.elidedText(line, Qt.TextElideMode.ElideRight, room) for line in lines)


class Marker(_Overlay):
    """A small ring at the point under the pointer, and where the same point is in the other panes."""

    SIZE = 15

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.resize(self.SIZE, self.SIZE)
        self.hide()

    def place(self, position: QPointF) -> None:
        """Centre it at a place in the parent."""
        half = (self.SIZE - 1) / 2
        self.move(round(position.x() - half), round(position.y() - half))
        self.show()

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            centre = QPointF(self.SIZE / 2, self.SIZE / 2)
            for color, width in ((QColor(255, 255, 255, 230), 3.4), (QColor("#14181e"), 1.6)):
                painter.setPen(QPen(color, width))
                painter.drawEllipse(centre, 4.6, 4.6)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor("#14181e"))
            painter.drawEllipse(centre, 1.3, 1.3)


class Pin(Marker):
    """A cross-hair at a point that was picked; it stays."""

    SIZE = 23

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            centre, reach = QPointF(self.SIZE / 2, self.SIZE / 2), self.SIZE / 2 - 1
            for color, width in ((QColor(255, 255, 255, 230), 4.0), (QColor("#14181e"), 1.8)):
                painter.setPen(QPen(color, width))
                painter.drawEllipse(centre, 6.0, 6.0)
                for right, down in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                    aside = QPointF(right, down)
                    painter.drawLine(centre + aside * 6.0, centre + aside * reach)


class ScaleBar(_Overlay):
    """A round length; in perspective that of things as far away as the middle of the view."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._per_mm, self._room, self._about = 1.0, 120.0, True
        self.resize(160, 30)

    def set_camera(self, camera: Camera, height: int) -> None:
        """Follow a camera in a view of some height [pixels]."""
        per_mm, about = height / (2 * camera.half_height), not camera.parallel
        if (per_mm, about) != (self._per_mm, self._about):
            self._per_mm, self._about = per_mm, about
            self.update()

    def set_room(self, width: float) -> None:
        """Never be longer than this."""
        room = min(max(width, 40.0), 150.0)
        if room != self._room:
            self._room = room
            self.resize(round(room) + 10, 30)
            self.update()

    def show_units(self) -> None:
        """Mark a round length of the unit chosen."""
        self.update()

    @property
    def length(self) -> float:
        """That is marked, in the unit shown [mm or in]."""
        return round_length(self._room / (self._per_mm * units.factor("mm")))

    @property
    def label(self) -> str:
        """The words at the bar."""
        return f"{'≈ ' if self._about else ''}{number(self.length, 'g')} {units.unit_shown('mm')}"

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            font = QFont(self.font())
            font.setPointSizeF(max(font.pointSizeF() * 0.92, 7.0))
            painter.setFont(font)
            width, ground = self.length * units.factor("mm") * self._per_mm, self.height() - 5.0
            plate = QColor(self.colors.surface)
            plate.setAlpha(PLATE_ALPHA)
            wide = max(width, painter.fontMetrics().horizontalAdvance(self.label))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(plate)
            painter.drawRoundedRect(QRectF(0, 0, wide + 8, self.height()), 5, 5)
            painter.setPen(QPen(QColor(self.colors.text), 1.6))
            painter.drawLine(QPointF(4, ground), QPointF(4 + width, ground))
            for x in (4.0, 4.0 + width):
                painter.drawLine(QPointF(x, ground - 4), QPointF(x, ground + 3))
            painter.drawText(QRectF(4, 0, max(width, 90.0), ground - 4), Qt.AlignmentFlag.AlignBottom, self.label)


def round_length(longest: float) -> float:
    """The largest 1, 2 or 5 times a power of ten that is not longer."""
    power = 10.0 ** math.floor(math.log10(longest))
    return float(f"{max(step for step in (1, 2, 5) if step * power <= longest * (1 + 1e-9)) * power:.3g}")


class Axes(_Overlay):
    """The directions x, y and z of the gear, turning with the camera."""

    _COLORS = ("#d1495b", "#3c9d5d", "#3d7edb")

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._tips = np.zeros((3, 3))
        self.resize(72, 72)

    def set_camera(self, camera: Camera) -> None:
        """Follow a camera."""
        tips = np.stack([camera.right, camera.up, camera.back], axis=-1)
        if not np.array_equal(tips, self._tips):
            self._tips = tips
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            font = QFont(self.font())
            font.setPointSizeF(max(font.pointSizeF() * 0.9, 7.0))
            font.setBold(True)
            painter.setFont(font)
            centre, length = QPointF(36, 36), 23.0
            for axis in np.argsort(self._tips[:, 2]):
                right, up, depth = self._tips[axis]
                color = QColor(self._COLORS[axis])
                color.setAlphaF(1.0 if depth > -0.2 else 0.55)
                tip = centre + QPointF(right, -up) * length
                painter.setPen(QPen(color, 2.0, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
                painter.drawLine(centre, tip)
                label = centre + QPointF(right, -up) * (length + 8.0)
                painter.drawText(
                    QRectF(label.x() - 8, label.y() - 8, 16, 16), Qt.AlignmentFlag.AlignCenter, "xyz"[axis]
                )


class Divider(_Overlay):
    """A hairline between two panes."""

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.fillRect(self.rect(), QColor(self.colors.border_strong))

    def sizeHint(self) -> QSize:
        return QSize(1, 1)
