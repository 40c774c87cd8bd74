"""The equation browser: every formula of the theory, its departure from the paper, and this design's numbers."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QByteArray, QEvent, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QPainter, QPaintEvent
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import (
    QDialog,
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QScrollArea,
    QSplitter,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from gearstudio.catalogue import MEMBERS
from gearstudio.design import all_field_specs
from ui.analysis.background import Newest
from ui.help.typeset import drawing
from ui.theme import tokens
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.equations import Equation, Numbers
    from ui.session import Session

_SIZE = (900, 620)
_SCALE = 4 / 3
_KEY = Qt.ItemDataRole.UserRole


class Sheet(QWidget):
    """Shows one drawing at its own size."""

    def __init__(self) -> None:
        super().__init__()
        self._renderer = QSvgRenderer(self)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)

    def show_drawing(self, svg: bytes) -> None:
        """Show a drawing."""
        self._renderer.load(QByteArray(svg))
        size = self._renderer.defaultSize()
        self.setFixedSize(QSize(round(size.width() * _SCALE), round(size.height() * _SCALE)))
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the drawing."""
        super().paintEvent(event)
        with QPainter(self) as painter:
            self._renderer.render(painter)


class EquationBrowser(QDialog):
    """A list of equations and the chosen one, with the numbers of the session's design.

    Signals
    -------
    field_asked(str)
        A parameter that the equation uses shall come into sight.
    """

    field_asked = Signal(str)

    def __init__(self, session: Session, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Equations"))
        self.setWindowFlag(Qt.WindowType.WindowMaximizeButtonHint)
        self.resize(*_SIZE)
        self._session = session
        self._setter = Newest("equations", self)
        self._setter.done.connect(self._on_set)
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Find an equation"))
        self.search.setAccessibleName(tr("Find an equation"))
        self.search.setToolTip(tr("Words of the title or the text, or the paper's number"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._filter)
        self.list = QTreeWidget()
        self.list.setHeaderHidden(True)
        self.list.setAccessibleName(tr("Equations"))
        self.list.setToolTip(tr("A mark shows where the paper prints something else"))
        self.list.currentItemChanged.connect(lambda *_: self.show_chosen())
        self.sheet = Sheet()
        self.sheet.setAccessibleName(tr("The equation"))
        self.sheet.setProperty("role", "page")
        self.used_by = self._make_used_by()
        self._lay_out()
        self._fill()
        session.design_changed.connect(self._on_design_changed)
        self.finished.connect(self._on_finished)

    def choose(self, key: str) -> None:
        """Show the equation of a key."""
        for item in self._items():
            if item.data(0, _KEY).key == key:
                if item.isHidden():
                    self.search.clear()
                self.list.setCurrentItem(item)
                self.list.scrollToItem(item)

    def show_chosen(self) -> None:
        """Set the chosen equation with the numbers of the design as it is now."""
        item = self.list.currentItem()
        one: Equation | None = item.data(0, _KEY) if item is not None else None
        if one is None:
            return
        self.used_by.setText(used_by_text(one.key))
        self.sheet.setAccessibleDescription(f"{tr(one.title)}. {tr(one.meaning)}")
        pair, colors, width = self._session.pair, tokens(), (self._area.viewport().width() - 8) / _SCALE

        def work() -> bytes:
            from gearstudio.equations import holds, numbers_of

            found = {} if pair is None else {name: numbers_of(one, pair, name) for name in MEMBERS}
            put: dict[str, Numbers] = {name: numbers for name, numbers in found.items() if numbers is not None}
            return drawing(one, put, colors, max(width, 240), applies=pair is None or holds(one, pair))

        self._setter.request(one.key, work)

    @property
    def key(self) -> str:
        """Key of the equation in sight; empty without one."""
        item = self.list.currentItem()
        one: Equation | None = item.data(0, _KEY) if item is not None else None
        return one.key if one is not None else ""

    def show_units(self) -> None:
        """Show the numbers in the unit that the user chose now."""
        self.show_chosen()

    def resizeEvent(self, event: object) -> None:
        """Set the lines anew for the width there is."""
        super().resizeEvent(event)  # type: ignore[arg-type]
        self.show_chosen()

    def changeEvent(self, event: QEvent) -> None:
        """Take the colours of the theme in use."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self.isVisible():
            self._mark()
            self.show_chosen()

    def _lay_out(self) -> None:
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.search)
        column.addWidget(self.list, 1)
        self._area = QScrollArea()
        self._area.setAccessibleName(tr("The equation"))
        self._area.setProperty("role", "stop")
        self._area.setWidget(self.sheet)
        self._area.setFrameShape(QFrame.Shape.StyledPanel)
        right = QWidget()
        beside = QVBoxLayout(right)
        beside.setContentsMargins(0, 0, 0, 0)
        beside.addWidget(self._area, 1)
        beside.addWidget(self.used_by)
        split = QSplitter()
        split.addWidget(left)
        split.addWidget(right)
        split.setStretchFactor(1, 1)
        split.setSizes([330, 630])
        split.splitterMoved.connect(lambda *_: self.show_chosen())
        QHBoxLayout(self).addWidget(split)

    def _make_used_by(self) -> QLabel:
        label = QLabel()
        label.setWordWrap(True)
        label.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        label.setAccessibleName(tr("Parameters that the equation uses"))
        label.setToolTip(tr("Go to the parameter in the window"))
        label.linkActivated.connect(self.field_asked)
        return label

    def _fill(self) -> None:
        from gearstudio.equations import EQUATIONS

        groups: dict[str, QTreeWidgetItem] = {}
        for one in EQUATIONS:
            if one.group not in groups:
                groups[one.group] = QTreeWidgetItem(self.list, [tr(one.group)])
                groups[one.group].setFlags(Qt.ItemFlag.ItemIsEnabled)
            mark = " ≠" if one.printed else ""
            number = f"({one.paper}) " if one.paper else ""
            item = QTreeWidgetItem(groups[one.group], [f"{number}{tr(one.title)}{mark}"])
            item.setData(0, _KEY, one)
            item.setToolTip(0, item.text(0))
        self.list.expandAll()
        self.list.setCurrentItem(self._items()[0])
        self._mark()

    def _mark(self) -> None:
        """Grey what does not hold for the design."""
        from gearstudio.equations import holds

        pair, muted = self._session.pair, QBrush(QColor(tokens().muted))
        for item in self._items():
            usual = pair is None or holds(item.data(0, _KEY), pair)
            item.setForeground(0, QBrush() if usual else muted)

    def _items(self) -> list[QTreeWidgetItem]:
        tops = [self.list.topLevelItem(i) for i in range(self.list.topLevelItemCount())]
        return [top.child(k) for top in tops if top is not None for k in range(top.childCount())]

    def _filter(self, text: str) -> None:
        wanted = text.casefold().split()
        for item in self._items():
            one: Equation = item.data(0, _KEY)
            words = f"({one.paper}) {tr(one.title)} {tr(one.meaning)} {tr(one.group)}".casefold()
            item.setHidden(not all(word in words for word in wanted))
        for i in range(self.list.topLevelItemCount()):
            top = self.list.topLevelItem(i)
            if top is not None:
                top.setHidden(all(top.child(k).isHidden() for k in range(top.childCount())))

    def _on_set(self, key: str, svg: bytes) -> None:
        self.sheet.show_drawing(svg)

    def _on_design_changed(self, _design: object) -> None:
        self._mark()
        self.show_chosen()

    def _on_finished(self) -> None:
        self._session.design_changed.disconnect(self._on_design_changed)
        self._setter.close()
        self.deleteLater()


def used_by_text(key: str) -> str:
    """The parameters that an equation uses, each with a link; those of the four flanks once. Empty without any."""
    from gearstudio.equations import fields_of

    specs = all_field_specs()
    links: dict[str, str] = {}
    for path in fields_of(key):
        links.setdefault(tr(specs[path].title), f'<a href="{path}">{escape(tr(specs[path].title))}</a>')
    return tr("Used by: {parameters}", parameters=" · ".join(links.values())) if links else ""
