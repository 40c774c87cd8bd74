"""How a page of the help is set: room around headings and tables, quiet lines, low indices, no slanted Chinese."""

from __future__ import annotations

import re

from PySide6.QtGui import (
    QBrush,
    QColor,
    QFont,
    QTextBlock,
    QTextBlockFormat,
    QTextCharFormat,
    QTextCursor,
    QTextDocument,
    QTextTable,
)

_ABOVE = {1: 4.0, 2: 22.0, 3: 14.0}
_BELOW, _AROUND, _PADDING = 7.0, 9.0, 5.0
_ROUNDING = 2.0
_LINE_PERCENT = 128
_PICTURE = "\ufffc"
_INDEX = re.compile(r"(?<=(?<!\w)[A-Zα-ω])_([a-zα-ω]{1,3})(?![\w])")
_IDEOGRAPHS = range(0x3000, 0xA000)


def set_page(document: QTextDocument, line: QColor) -> None:
    """Set a document made of Markdown; `line` is the colour of the tables' lines."""
    for table in document.rootFrame().childFrames():
        if isinstance(table, QTextTable):
            _set_table(table, line)
    cursor, block = QTextCursor(document), document.begin()
    while block.isValid():
        level = block.blockFormat().headingLevel()
        look = QTextBlockFormat()
        if level:
            look.setTopMargin(_ABOVE.get(level, _ABOVE[3]))
            look.setBottomMargin(_BELOW)
        elif block.blockFormat().nonBreakableLines():
            look.setNonBreakableLines(False)
            look.setBottomMargin(0.0 if block.next().blockFormat().nonBreakableLines() else _AROUND)
        elif _PICTURE not in block.text():
            look.setLineHeight(_LINE_PERCENT, QTextBlockFormat.LineHeightTypes.ProportionalHeight.value)
        cursor.setPosition(block.position())
        cursor.mergeBlockFormat(look)
        _stand_up(cursor, block)
        _lower(cursor, block)
        block = block.next()


def _set_table(table: QTextTable, line: QColor) -> None:
    look = table.format()
    look.setCellPadding(_PADDING)
    look.setCellSpacing(0)
    look.setBorderCollapse(True)
    look.setBorderBrush(QBrush(line))
    look.setRightMargin(_ROUNDING)
    look.setTopMargin(_AROUND)
    look.setBottomMargin(_AROUND)
    table.setFormat(look)


def _stand_up(cursor: QTextCursor, block: QTextBlock) -> None:
    """Emphasise ideographs by weight instead of slant."""
    look = QTextCharFormat()
    look.setFontItalic(False)
    look.setFontWeight(QFont.Weight.DemiBold)
    for start, length in _slanted(block):
        cursor.setPosition(start)
        cursor.setPosition(start + length, QTextCursor.MoveMode.KeepAnchor)
        cursor.mergeCharFormat(look)


def _lower(cursor: QTextCursor, block: QTextBlock) -> None:
    """Set indices such as that of δ_b below the line; code stays as it is."""
    low = QTextCharFormat()
    low.setVerticalAlignment(QTextCharFormat.VerticalAlignment.AlignSubScript)
    found, pieces = [], block.begin()
    while not pieces.atEnd():
        piece = pieces.fragment()
        if not piece.charFormat().fontFixedPitch():
            found += [(piece.position() + m.start(), m.group(1)) for m in _INDEX.finditer(piece.text())]
        pieces += 1
    for place, index in reversed(found):
        cursor.setPosition(place)
        cursor.setPosition(place + 1, QTextCursor.MoveMode.KeepAnchor)
        cursor.removeSelectedText()
        cursor.setPosition(place + len(index), QTextCursor.MoveMode.KeepAnchor)
        cursor.mergeCharFormat(low)


def _slanted(block: QTextBlock) -> list[tuple[int, int]]:
    """Place and length of the slanted pieces of a block that have ideographs."""
    found, pieces = [], block.begin()
    while not pieces.atEnd():
        piece = pieces.fragment()
        if piece.charFormat().fontItalic() and any(ord(letter) in _IDEOGRAPHS for letter in piece.text()):
            found.append((piece.position(), piece.length()))
        pieces += 1
    return found
