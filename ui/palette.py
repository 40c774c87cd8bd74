"""The command palette: every command and every parameter, found by a few letters."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape

from PySide6.QtCore import QEvent, QModelIndex, QObject, QPersistentModelIndex, QSettings, QSize, Qt
from PySide6.QtGui import QKeyEvent, QKeySequence, QPainter, QTextDocument
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QDialog,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from ui.fuzzy import fit
from ui.theme import tokens
from ui.words import tr

_Index = QModelIndex | QPersistentModelIndex
RECENT, MOST_RECENT = "palette/recent", 12
WIDTH, ROWS, ROW_HEIGHT = 600, 11, 30
OFFER, MARKUP, KEYS = (Qt.ItemDataRole.UserRole + step for step in range(3))


@dataclass(frozen=True)
class Offer:
    """Something that the palette can do.

    Attributes
    ----------
    id : str
        For the list of recent ones.
    title, place, keys, tip : str
        Words, where it is found otherwise, its key, and what it does.
    enabled : bool
    run : callable
    """

    id: str
    title: str
    place: str
    keys: str
    tip: str
    enabled: bool
    run: Callable[[], object]


class Palette(QDialog):
    """A line to type in over a list that narrows; Enter carries out, Escape leaves."""

    def __init__(self, offers: Sequence[Offer], settings: QSettings | None, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Dialog | Qt.WindowType.FramelessWindowHint)
        self.setWindowTitle(tr("Command palette"))
        self.setProperty("role", "palette")
        self._settings = settings
        self._recent = recent(settings)
        rank = {identifier: place for place, identifier in enumerate(self._recent)}
        self._offers = sorted(offers, key=lambda offer: rank.get(offer.id, len(rank)))
        self.line = QLineEdit()
        self.line.setPlaceholderText(tr("Type a command or a parameter"))
        self.line.setAccessibleName(tr("Command or parameter"))
        self.line.setToolTip(tr("A few letters are enough; Up and Down choose, Enter carries out"))
        self.line.textChanged.connect(self._narrow)
        self.line.installEventFilter(self)
        self.list = QListWidget()
        self.list.setItemDelegate(OfferDelegate(self.list))
        self.list.setAccessibleName(tr("Commands found"))
        self.list.setToolTip(tr("Enter or a click carries out"))
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.list.setUniformItemSizes(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.list.itemClicked.connect(self._run)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        layout.setSpacing(6)
        layout.addWidget(self.line)
        layout.addWidget(self.list)
        self.setFixedSize(WIDTH, ROWS * ROW_HEIGHT + 60)
        self._narrow("")

    @property
    def titles(self) -> list[str]:
        """What is listed, from the top."""
        return [self.list.item(row).data(OFFER).title for row in range(self.list.count())]

    def open_over(self, window: QWidget) -> None:
        """Appear at the top of a window."""
        corner = window.mapToGlobal(window.rect().topLeft())
        self.move(corner.x() + (window.width() - self.width()) // 2, corner.y() + 60)
        self.open()
        self.line.setFocus()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.KeyPress and isinstance(event, QKeyEvent):
            moves = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown)
            if event.key() in moves:
                QApplication.sendEvent(self.list, event)
                return True
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self._run(self.list.currentItem())
                return True
        return super().eventFilter(watched, event)

    def _narrow(self, typed: str) -> None:
        found = []
        for order, offer in enumerate(self._offers):
            hit = fit(typed, offer.title)
            wide = hit or fit(typed, f"{offer.place} {offer.title}")
            if wide is not None:
                places = hit[1] if hit else ()
                found.append((not offer.enabled, hit is None, -wide[0] if typed else 0, order, offer, places))
        found.sort(key=lambda row: row[:4])
        self.list.clear()
        for *_, offer, places in found:
            item = QListWidgetItem(offer.title)
            item.setData(OFFER, offer)
            item.setData(MARKUP, _marked(offer, places))
            item.setData(KEYS, offer.keys)
            item.setToolTip(offer.tip)
            item.setData(Qt.ItemDataRole.AccessibleTextRole, f"{offer.title} {offer.keys}".strip())
            if not offer.enabled:
                item.setFlags(Qt.ItemFlag.NoItemFlags)
            self.list.addItem(item)
        self.list.setCurrentRow(0 if found and found[0][4].enabled else -1)

    def _run(self, item: QListWidgetItem | None) -> None:
        if item is None or not item.flags() & Qt.ItemFlag.ItemIsEnabled:
            return
        offer: Offer = item.data(OFFER)
        if self._settings is not None:
            kept = [offer.id, *(other for other in self._recent if other != offer.id)]
            self._settings.setValue(RECENT, kept[:MOST_RECENT])
        self.accept()
        offer.run()


class OfferDelegate(QStyledItemDelegate):
    """Paints the title with the letters found in bold, its place muted, and the keys on the right."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: _Index) -> None:
        self.initStyleOption(option, index)
        option.text = ""
        option.widget.style().drawControl(QStyle.ControlElement.CE_ItemViewItem, option, painter, option.widget)
        words = tokens()
        enabled = bool(option.state & QStyle.StateFlag.State_Enabled)
        document = QTextDocument()
        document.setDefaultFont(option.font)
        document.setDocumentMargin(0)
        color = words.text if enabled else words.faint
        document.setHtml(f'<span style="color:{color}">{index.data(MARKUP).replace("%muted", words.muted)}</span>')
        area = option.rect.adjusted(10, 0, -12, 0)
        keys = index.data(KEYS)
        width = option.fontMetrics.horizontalAdvance(keys) if keys else 0
        painter.save()
        painter.setClipRect(area.adjusted(0, 0, -width - 10, 0))
        painter.translate(area.left(), area.center().y() - document.size().height() / 2 + 1)
        document.drawContents(painter)
        painter.restore()
        painter.setPen(option.palette.placeholderText().color())
        painter.drawText(area, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, keys)

    def sizeHint(self, option: QStyleOptionViewItem, index: _Index) -> QSize:
        return QSize(option.rect.width(), ROW_HEIGHT)


def recent(settings: QSettings | None) -> list[str]:
    """What was carried out last, the newest first."""
    value = settings.value(RECENT, []) if settings is not None else []
    found = [value] if isinstance(value, str) else value
    return [str(name) for name in found] if isinstance(found, list) else []


def keys_text(keys: QKeySequence) -> str:
    """Keys as the system writes them."""
    return keys.toString(QKeySequence.SequenceFormat.NativeText)


def _marked(offer: Offer, places: Sequence[int]) -> str:
    letters = [f"<b>{escape(x)}</b>" if i in places else escape(x) for i, x in enumerate(offer.title)]
    place = f'&nbsp;&nbsp;<span style="color:%muted">{escape(offer.place)}</span>' if offer.place else ""
    return "".join(letters) + place
