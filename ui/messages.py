"""Messages to the user: a bar over the views for what was to be expected, a dialog for what was not."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPlainTextEdit,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.fields import set_severity
from ui.keyboard import tab_as_read
from ui.theme import icon, set_icon
from ui.words import Said, told, tr


class MessageBar(QFrame):
    """One line about something the user should know, with Details and Copy; hidden when there is none."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("role", "message")
        self.topic = ""
        self._severity = "info"
        self._full = ""
        self._shown = ("", "", "", "")
        self._picture = QLabel()
        self._text = QLabel()
        self._text.setWordWrap(True)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._details = QPlainTextEdit()
        self._details.setReadOnly(True)
        self._details.setMaximumHeight(140)
        self._more = _flat_button(tr("Details"))
        self._more.setToolTip(tr("Show what else is known"))
        self._more.setCheckable(True)
        self._more.toggled.connect(self._details.setVisible)
        self._copy = _flat_button(tr("Copy"))
        self._copy.setToolTip(tr("Copy the message with its details"))
        self._details.setAccessibleName(tr("Details of the message"))
        self._details.setToolTip(tr("What else is known"))
        self._copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(self._full))
        close = QToolButton()
        close.setProperty("role", "flat")
        set_icon(close, "close")
        close.setIconSize(QSize(14, 14))
        close.setToolTip(tr("Dismiss"))
        close.setAccessibleName(tr("Dismiss"))
        close.clicked.connect(self.hide)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(self._picture)
        row.addWidget(self._text, 1)
        for button in (self._more, self._copy, close):
            row.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 6, 6, 6)
        layout.addLayout(row)
        layout.addWidget(self._details)
        self.hide()

    @property
    def text(self) -> str:
        """The line that is shown; empty when the bar is hidden."""
        return self._text.text() if not self.isHidden() else ""

    def show_message(self, severity: str, text: str, details: str = "", *, topic: str = "") -> None:
        """Show a message (``"error"``, ``"warning"``, ``"info"``) in place of the one before.

        ``topic`` says what it is about, so that :meth:`clear` takes away only that.
        """
        self.topic = topic
        self._severity = severity
        self._shown = (severity, text, details, topic)
        details = details.again() if isinstance(details, Said) else details
        self._full = f"{told(text)}\n\n{details}" if details else told(text)
        self._text.setText(told(text))
        self._details.setPlainText(details)
        self._more.setVisible(bool(details))
        self._more.setChecked(False)
        self._details.hide()
        self.refresh_icons()
        set_severity(self, severity)
        self.show()

    def keep_state(self) -> object:
        """The message in sight, for `take_state`."""
        return None if self.isHidden() else self._shown

    def take_state(self, state: object) -> None:
        """Show the message of another bar, in the language of the window."""
        if isinstance(state, tuple):
            severity, text, details, topic = state
            self.show_message(severity, text, details, topic=topic)

    def clear(self, topic: str | None = None) -> None:
        """Hide the message, if it is about this topic (None: whatever it is)."""
        if topic is None or topic == self.topic:
            self.hide()

    def refresh_icons(self) -> None:
        """Draw the icon in the theme's colour."""
        self._picture.setPixmap(icon(self._severity).pixmap(18, 18))


class ReportDialog(QDialog):
    """A text that can be copied whole: a crash report, or the versions of everything."""

    def __init__(self, title: str, words: str, report: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(title)
        self.resize(720, 460)
        self.report = report
        head = QLabel(words)
        head.setWordWrap(True)
        text = QPlainTextEdit(report)
        text.setReadOnly(True)
        text.setAccessibleName(tr("Report"))
        text.setToolTip(tr("Can be selected and copied"))
        text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        font = text.font()
        font.setFamilies(["Menlo", "Consolas", "DejaVu Sans Mono", "monospace"])
        text.setFont(font)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        copy = buttons.addButton(tr("Copy report"), QDialogButtonBox.ButtonRole.ActionRole)
        copy.setToolTip(tr("Copy all of the report"))
        buttons.button(QDialogButtonBox.StandardButton.Close).setToolTip(tr("Close the report"))
        copy.clicked.connect(lambda: QGuiApplication.clipboard().setText(self.report))
        copy.setAutoDefault(False)
        buttons.button(QDialogButtonBox.StandardButton.Close).setDefault(True)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(12)
        layout.addWidget(head)
        layout.addWidget(text, 1)
        layout.addWidget(buttons)
        tab_as_read(self, text, buttons)


def _flat_button(text: str) -> QPushButton:
    button = QPushButton(text)
    button.setProperty("role", "flat")
    return button
