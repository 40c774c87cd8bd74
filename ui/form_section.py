"""A group of the parameter form that folds, and tells from outside what it holds."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QSize, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from ui.fields import set_severity
from ui.theme import set_icon
from ui.words import tr


class Section(QWidget):
    """A titled group of rows; a click on the title folds it.

    Signals
    -------
    folded(bool)
        The user folded (True) or unfolded it.
    reset_requested()
    fold_all_requested(bool)
        All sections shall be folded (True) or unfolded.
    """

    folded = Signal(bool)
    reset_requested = Signal()
    fold_all_requested = Signal(bool)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._open, self._filtering, self._changed = True, False, 0
        self._title = QToolButton()
        self._title.setProperty("role", "section")
        self._title.setText(tr(title))
        self._title.setCheckable(True)
        self._title.setIconSize(QSize(16, 16))
        self._title.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._title.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._title.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._title.clicked.connect(self._on_clicked)
        self._changes, self._problems = QLabel(), QLabel()
        self._changes.setProperty("role", "muted")
        head = QHBoxLayout()
        head.setContentsMargins(0, 0, 2, 0)
        head.setSpacing(8)
        for widget in (self._title, self._problems, self._changes):
            head.addWidget(widget)
        self._top: list[QWidget] = []
        self._body = QWidget()
        self._rows = QVBoxLayout(self._body)
        self._rows.setContentsMargins(2, 0, 0, 6)
        self._rows.setSpacing(5)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(head)
        layout.addWidget(self._body)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.customContextMenuRequested.connect(self._show_menu)
        self.show_marks(0, "", 0)
        self.set_open(True)

    @property
    def is_open(self) -> bool:
        """Whether the rows are in sight, apart from a search."""
        return self._open

    @property
    def marks(self) -> str:
        """What the title says of the rows."""
        return " ".join(filter(None, (self._problems.text(), self._changes.text())))

    def add(self, row: QWidget) -> None:
        """Append a row."""
        self._rows.addWidget(row)

    def place_on_top(self, widget: QWidget) -> None:
        """Put something above the rows."""
        self._top.append(widget)
        self._rows.insertWidget(0, widget)

    def set_open(self, opened: bool) -> None:
        """Unfold or fold."""
        self._open = opened
        self._refresh()

    def set_filter(self, active: bool, hits: bool) -> None:
        """While fields are searched for, show the group only with its hits, unfolded."""
        self._filtering = active
        self.setVisible(hits or not active)
        self._refresh()

    def show_marks(self, changed: int, severity: str, problems: int) -> None:
        """How many fields differ from their defaults, and how many are wrong."""
        self._changed = changed
        self._changes.setText(tr("{count} changed", count=changed) if changed else "")
        self._changes.setToolTip(tr("Fields that differ from their defaults; the context menu resets the group"))
        self._problems.setText(f"▲ {problems}" if severity else "")
        self._problems.setToolTip(tr("Fields with a problem"))
        set_severity(self._problems, severity)
        for label in (self._changes, self._problems):
            label.setVisible(bool(label.text()))
        tip = tr("Fold or unfold this group")
        self._title.setToolTip(f"{tip} ({tr('{count} changed', count=changed)})" if changed else tip)

    def _refresh(self) -> None:
        shown = self._open or self._filtering
        self._title.setChecked(shown)
        set_icon(self._title, "chevron-down" if shown else "chevron-right")
        self._body.setVisible(shown)
        for widget in self._top:
            widget.setVisible(not self._filtering)

    def _on_clicked(self) -> None:
        if self._filtering:
            self._refresh()
        else:
            self.set_open(not self._open)
            self.folded.emit(not self._open)

    def _show_menu(self, place: QPoint) -> None:
        menu = self.make_menu()
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(self.mapToGlobal(place))

    def make_menu(self) -> QMenu:
        """What can be done with the group."""
        menu = QMenu(self)
        reset = menu.addAction(tr("Reset this group"))
        reset.setEnabled(bool(self._changed))
        reset.triggered.connect(self.reset_requested)
        menu.addSeparator()
        menu.addAction(tr("Fold all groups")).triggered.connect(lambda: self.fold_all_requested.emit(True))
        menu.addAction(tr("Unfold all groups")).triggered.connect(lambda: self.fold_all_requested.emit(False))
        return menu
