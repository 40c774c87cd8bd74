"""Colours, type and spacing of the window; light and dark, following the system.

Everything that is painted takes its colours from the :class:`Tokens` of :func:`tokens`; nothing else in the
window names a colour. The style sheet is ``style.qss``, a template filled with the tokens.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
from string import Template

from PySide6.QtCore import QByteArray, QDir, QObject, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPainter, QPalette, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QAbstractButton, QApplication, QWidget

HERE = Path(__file__).parent
ICON_SIZES = (20, 40)
DARK_PROPERTY, ICON_PROPERTY = "gearstudio_dark", "gearstudio_icon"


@dataclass(frozen=True)
class Tokens:
    """The colours of one theme, as ``#rrggbb``."""

    window: str
    surface: str
    sunken: str
    hover: str
    border: str
    border_strong: str
    text: str
    muted: str
    faint: str
    accent: str
    accent_soft: str
    on_accent: str
    error: str
    error_soft: str
    warning: str
    warning_soft: str
    ok: str
    view_top: str
    view_bottom: str


LIGHT = Tokens(
    window="#f3f4f7",
    surface="#ffffff",
    sunken="#f8f9fb",
    hover="#e9ecf1",
    border="#dcdfe6",
    border_strong="#bcc3cf",
    text="#1c2430",
    muted="#5c6677",
    faint="#737e90",
    accent="#2a62c4",
    accent_soft="#e1eafb",
    on_accent="#ffffff",
    error="#bf3029",
    error_soft="#fdeceb",
    warning="#9a6200",
    warning_soft="#fdf3dd",
    ok="#217a51",
    view_top="#fdfdfe",
    view_bottom="#e4e8ef",
)

DARK = Tokens(
    window="#191c22",
    surface="#21252d",
    sunken="#1d2027",
    hover="#2d323c",
    border="#343a45",
    border_strong="#4d5564",
    text="#e5e8ee",
    muted="#a0a8b7",
    faint="#838d9e",
    accent="#71a2f7",
    accent_soft="#2a3b5c",
    on_accent="#10161f",
    error="#f27b70",
    error_soft="#442628",
    warning="#e2b04c",
    warning_soft="#3d331f",
    ok="#5bc08f",
    view_top="#343b48",
    view_bottom="#1c2027",
)


def tokens() -> Tokens:
    """The colours of the theme in use."""
    return DARK if is_dark() else LIGHT


def is_dark() -> bool:
    """Whether the window is dark: the user's choice if there is one, else the system's."""
    return bool(QApplication.instance().property(DARK_PROPERTY))


def palette(colors: Tokens) -> QPalette:
    """A complete palette, so that plain Qt widgets and dialogs agree with the style sheet."""
    role = QPalette.ColorRole
    made = QPalette(QColor(colors.window))
    for target, color in (
        (role.Window, colors.window),
        (role.WindowText, colors.text),
        (role.Base, colors.surface),
        (role.AlternateBase, colors.sunken),
        (role.Text, colors.text),
        (role.PlaceholderText, colors.faint),
        (role.Button, colors.surface),
        (role.ButtonText, colors.text),
        (role.BrightText, colors.error),
        (role.ToolTipBase, colors.surface),
        (role.ToolTipText, colors.text),
        (role.Highlight, colors.accent),
        (role.HighlightedText, colors.on_accent),
        (role.Link, colors.accent),
        (role.LinkVisited, colors.accent),
        (role.Mid, colors.border),
        (role.Accent, colors.accent),
    ):
        made.setColor(target, QColor(color))
    for target in (role.WindowText, role.Text, role.ButtonText):
        made.setColor(QPalette.ColorGroup.Disabled, target, QColor(colors.faint))
    return made


def style_sheet(colors: Tokens) -> str:
    """``style.qss`` with the colours filled in; it finds icons as ``icons:NAME.svg``, in whatever folder they are."""
    QDir.setSearchPaths("icons", [str(HERE / "icons")])
    template = Template((HERE / "style.qss").read_text(encoding="utf-8"))
    return template.substitute(asdict(colors))


def icon(name: str) -> QIcon:
    """Icon ``icons/NAME.svg``, drawn in the theme's text colour (greyed when disabled), sharp at double scale too."""
    colors = tokens()
    svg = (HERE / "icons" / f"{name}.svg").read_text(encoding="utf-8")
    made = QIcon()
    for mode, color in ((QIcon.Mode.Normal, colors.text), (QIcon.Mode.Disabled, colors.faint)):
        for size in ICON_SIZES:
            made.addPixmap(_paint(svg.replace("currentColor", color), size), mode)
    return made


def set_icon(button: QAbstractButton, name: str) -> None:
    """Give a button an icon that :func:`refresh_icons` draws anew when the colours change."""
    button.setProperty(ICON_PROPERTY, name)
    button.setIcon(icon(name))


def refresh_icons(window: QWidget) -> None:
    """Draw the icons of all buttons in a window in the theme's colours."""
    for button in window.findChildren(QAbstractButton):
        name = button.property(ICON_PROPERTY)
        if name:
            button.setIcon(icon(name))


def _paint(svg: str, size: int) -> QPixmap:
    pixmap = QPixmap(QSize(size, size))
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    QSvgRenderer(QByteArray(svg.encode())).render(painter)
    painter.end()
    return pixmap


class Theme(QObject):
    """Keeps the application's palette and style sheet in step with the system's light or dark scheme.

    Signals
    -------
    changed(object)
        The new :class:`Tokens`; widgets that paint themselves or hold icons refresh.
    """

    changed = Signal(object)

    def __init__(self, application: QApplication) -> None:
        super().__init__(application)
        self._application = application
        self._chosen = Qt.ColorScheme.Unknown
        application.setStyle("Fusion")
        self._take_scheme()
        application.styleHints().colorSchemeChanged.connect(self._on_scheme_changed)

    def choose(self, scheme: Qt.ColorScheme) -> None:
        """Light or dark by the user's choice; ``Unknown`` follows the system again."""
        self._chosen = scheme
        self._application.styleHints().setColorScheme(scheme)
        self._on_scheme_changed()

    def apply(self) -> None:
        """Give the application the style sheet: once for a window that is complete, not widget by widget."""
        self._application.setStyleSheet(style_sheet(tokens()))

    def _on_scheme_changed(self) -> None:
        self._take_scheme()
        self.apply()
        self.changed.emit(tokens())

    def _take_scheme(self) -> None:
        scheme = self._chosen
        if scheme == Qt.ColorScheme.Unknown:
            scheme = self._application.styleHints().colorScheme()
        self._application.setProperty(DARK_PROPERTY, scheme == Qt.ColorScheme.Dark)
        self._application.setPalette(palette(tokens()))
