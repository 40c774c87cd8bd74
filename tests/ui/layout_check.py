"""Finds in a window what has too little room: words that are cut, widgets that overlap or reach out of their parent."""

from __future__ import annotations

import re
from collections.abc import Iterator

from PySide6.QtCore import QModelIndex, QPoint, QRect, Qt
from PySide6.QtGui import QFont, QFontMetrics, QTextDocument
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QCheckBox,
    QComboBox,
    QDockWidget,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLayout,
    QLineEdit,
    QMainWindow,
    QPushButton,
    QRadioButton,
    QScrollArea,
    QStyle,
    QStyleOptionComboBox,
    QStyleOptionFrame,
    QTabBar,
    QWidget,
)

from ui.charts.frame import _Hint as Hint

LEAST = (1280, 720)
_BREAKS = re.compile(r"\s+|(?<=[/\u2e80-\uffef])|(?=[\u2e80-\uffef])")
"""Where a line may end: at blanks, and beside the signs of Chinese."""
SLACK = 1
"""Pixels that a rounded text width may lack."""
MOST_ROWS = 80


def faults(top: QWidget) -> list[str]:
    """Everything that is wrong in what is visible of a window."""
    found = list(_too_large(top))
    for widget in (top, *top.findChildren(QWidget)):
        if widget.isVisible() and widget.window() is top and not _put_aside(widget):
            found += [f"{_where(widget)}: {fault}" for fault in (*_cut(widget), *_crowded(widget))]
    return found


def _put_aside(widget: QWidget) -> bool:
    """Whether it lies outside the window, as a main window leaves what is behind another tab."""
    return isinstance(widget, QTabBar | QDockWidget) and widget.visibleRegion().isEmpty()


def _too_large(top: QWidget) -> Iterator[str]:
    if not isinstance(top, QMainWindow) and (top.width() > LEAST[0] or top.height() > LEAST[1]):
        yield f"{_where(top)}: {top.width()} x {top.height()} is more than the smallest window has"
    least = top.minimumSizeHint()
    if least.width() > LEAST[0] or least.height() > LEAST[1]:
        yield f"{_where(top)}: needs {least.width()} x {least.height()}"


# ---- words ---------------------------------------------------------------------------------------------


def _cut(widget: QWidget) -> Iterator[str]:
    if isinstance(widget, QLabel):
        yield from _cut_label(widget)
    elif isinstance(widget, QCheckBox | QRadioButton):
        yield from _narrow(widget, widget.text(), widget.sizeHint().width())
    elif isinstance(widget, QAbstractButton):
        yield from _cut_button(widget)
    elif isinstance(widget, QComboBox):
        yield from _cut_combo(widget)
    elif isinstance(widget, QLineEdit):
        yield from _cut_line(widget)
    elif isinstance(widget, QTabBar):
        yield from _narrow(widget, "tabs", widget.sizeHint().width())
    elif isinstance(widget, QHeaderView):
        yield from _cut_sections(widget)
    elif isinstance(widget, QAbstractItemView):
        yield from _cut_cells(widget)
    elif isinstance(widget, QGroupBox):
        yield from _narrow(widget, widget.title(), widget.minimumSizeHint().width())


def _narrow(widget: QWidget, text: str, needed: int) -> Iterator[str]:
    if text and needed > widget.width() + SLACK:
        yield f"“{text[:60]}” needs {needed} of {widget.width()} px"


def _cut_label(label: QLabel) -> Iterator[str]:
    if not label.text() or isinstance(label, Hint):
        return
    least = label.minimumSizeHint()
    if not label.wordWrap():
        yield from _narrow(label, _plain(label.text()), least.width())
        if least.height() > label.height() + SLACK:
            yield f"“{_plain(label.text())[:60]}” needs {least.height()} of {label.height()} px of height"
        return
    needed = label.heightForWidth(label.width())
    if needed > label.height() + SLACK:
        yield f"lines of “{_plain(label.text())[:60]}” need {needed} of {label.height()} px"
    word = max(_BREAKS.split(_plain(label.text())), key=label.fontMetrics().horizontalAdvance)
    yield from _narrow(label, word, label.fontMetrics().horizontalAdvance(word))


def _cut_button(button: QAbstractButton) -> Iterator[str]:
    text = button.text().replace("&&", "\0").replace("&", "").replace("\0", "&")
    if not text or (not isinstance(button, QPushButton) and button.toolButtonStyle() == _ICON_ONLY):  # type: ignore[attr-defined]
        return
    font = QFont(button.font())
    if button.isCheckable():
        font.setBold(True)
    needed = QFontMetrics(font).horizontalAdvance(text) + 8 + (button.iconSize().width() if _has_icon(button) else 0)
    yield from _narrow(button, text, needed)


_ICON_ONLY = Qt.ToolButtonStyle.ToolButtonIconOnly


def _has_icon(button: QAbstractButton) -> bool:
    return not button.icon().isNull()


def _cut_combo(combo: QComboBox) -> Iterator[str]:
    option = QStyleOptionComboBox()
    combo.initStyleOption(option)
    field = combo.style().subControlRect(
        QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField, combo
    )
    for index in range(combo.count()):
        icon = 0 if combo.itemIcon(index).isNull() else combo.iconSize().width() + 4
        needed = combo.fontMetrics().horizontalAdvance(combo.itemText(index)) + icon
        if needed > field.width() + SLACK:
            yield f"choice “{combo.itemText(index)}” needs {needed} of {field.width()} px"


def _cut_line(line: QLineEdit) -> Iterator[str]:
    option = QStyleOptionFrame()
    line.initStyleOption(option)
    room = line.style().subElementRect(QStyle.SubElement.SE_LineEditContents, option, line).width()
    room -= line.textMargins().left() + line.textMargins().right() + 4
    texts = [line.text()] if line.text() else [line.placeholderText()]
    box = line.parentWidget()
    if isinstance(box, QAbstractSpinBox):
        texts.append(box.specialValueText())
    elif line.text() and not line.isReadOnly() and len(line.text()) > 20:
        return
    for text in texts:
        if line.fontMetrics().horizontalAdvance(text) > room + SLACK:
            yield f"“{text[:60]}” needs {line.fontMetrics().horizontalAdvance(text)} of {room} px"


def _cut_sections(header: QHeaderView) -> Iterator[str]:
    model = header.model()
    if model is None or header.orientation() is not Qt.Orientation.Horizontal:
        return
    for section in range(header.count()):
        text = model.headerData(section, Qt.Orientation.Horizontal)
        if not isinstance(text, str) or header.isSectionHidden(section):
            continue
        needed = header.fontMetrics().horizontalAdvance(max(text.split("\n"), key=len)) + 8
        if needed > header.sectionSize(section) + SLACK:
            yield f"heading “{text}” needs {needed} of {header.sectionSize(section)} px"


def _cut_cells(view: QAbstractItemView) -> Iterator[str]:
    """Cells in sight whose text is elided without a tip that tells the whole."""
    for index in _cells_in_sight(view):
        text, room = str(index.data() or ""), view.visualRect(index)
        if not text or not room.isValid() or view.indexWidget(index) is not None:
            continue
        needed = view.sizeHintForIndex(index)
        if getattr(view, "wordWrap", bool)():
            cut = needed.height() > room.height() + SLACK
        else:
            cut = needed.width() > room.width() + SLACK and text not in str(index.data(Qt.ItemDataRole.ToolTipRole))
        if cut:
            yield f"cell “{text[:60]}” needs {needed.width()} x {needed.height()} of {room.width()} x {room.height()}"


def _cells_in_sight(view: QAbstractItemView) -> Iterator[QModelIndex]:
    model = view.model()
    if model is None:
        return
    columns = model.columnCount() if hasattr(view, "horizontalHeader") or hasattr(view, "header") else 1
    for row in range(min(model.rowCount(), MOST_ROWS)):
        for column in range(columns):
            index = model.index(row, column)
            if view.viewport().rect().contains(view.visualRect(index).center()):
                yield index


def _plain(text: str) -> str:
    if not Qt.mightBeRichText(text):
        return text
    document = QTextDocument()
    document.setHtml(text)
    return document.toPlainText()


# ---- places --------------------------------------------------------------------------------------------


def _crowded(parent: QWidget) -> Iterator[str]:
    """Widgets of a parent's layout that lie over each other or outside it."""
    inside = [one for one in _arranged(parent) if one.isVisible() and one.parentWidget() is parent]
    inside = [one for one in inside if not _put_aside(one)]
    for number, widget in enumerate(inside):
        place = widget.geometry()
        if not _scrolls(parent) and not parent.rect().adjusted(-1, -1, 1, 1).contains(place):
            yield f"{_where(widget)} reaches out: {_rect(place)} of {parent.width()} x {parent.height()}"
        for other in inside[:number]:
            shared = place & other.geometry()
            if shared.width() > SLACK and shared.height() > SLACK:
                yield f"{_where(widget)} lies over {_where(other)}: {_rect(shared)}"


def _arranged(parent: QWidget) -> list[QWidget]:
    """The children that stand in the parent's layout or in one within it.

    Asked of the layouts, not of their items: what Qt deletes behind the bindings' back must not come to Python.
    """
    if parent.layout() is None:
        return []
    layouts = [parent.layout(), *parent.layout().findChildren(QLayout)]
    flat = [child for child in parent.children() if isinstance(child, QWidget) and not child.isWindow()]
    return [child for child in flat if any(one.indexOf(child) >= 0 for one in layouts)]


def _scrolls(parent: QWidget) -> bool:
    above = parent.parentWidget()
    return isinstance(parent, QScrollArea) or isinstance(above, QAbstractScrollArea)


def _rect(place: QRect) -> str:
    corner: QPoint = place.topLeft()
    return f"{place.width()} x {place.height()} at {corner.x()}, {corner.y()}"


def _where(widget: QWidget) -> str:
    names = []
    step: QWidget | None = widget
    while step is not None and len(names) < 3:
        said = step.objectName() if not step.objectName().startswith("qt_") else ""
        names.append(f"{type(step).__name__}{'#' + said if said else ''}")
        step = None if step.isWindow() else step.parentWidget()
    return " in ".join(names)
