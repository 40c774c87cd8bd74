"""Pictures into files, as a whole or not at all."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice, Qt
from PySide6.QtGui import QColor, QImage, QPainter

from gearstudio.errors import FileError
from gearstudio.files import write_bytes

QUALITY = 94


def write_picture(path: Path, picture: QImage) -> None:
    """Write a .png, or a .jpg on white.

    Raises
    ------
    FileError
        It cannot be written there, or the kind is not known.
    """
    kind = path.suffix.lower().lstrip(".").replace("jpeg", "jpg")
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    if kind not in ("png", "jpg") or not on_white(picture, kind).save(
        buffer, kind.upper(), QUALITY if kind == "jpg" else -1
    ):
        raise FileError(path, "pictures are written as .png or .jpg")
    write_bytes(path, bytes(buffer.data().data()))


def on_white(picture: QImage, kind: str) -> QImage:
    """A picture without transparency for kinds of files that know none."""
    if kind == "png" or not picture.hasAlphaChannel():
        return picture
    made = QImage(picture.size(), QImage.Format.Format_RGB32)
    made.fill(QColor(Qt.GlobalColor.white))
    painter = QPainter(made)
    painter.drawImage(0, 0, picture)
    painter.end()
    return made
