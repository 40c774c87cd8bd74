"""The guide and the glossary, to read beside the window, in its language where they are translated."""

from __future__ import annotations

import re
from pathlib import Path

from PySide6.QtCore import QEvent, QPoint, Qt, QTimer, QUrl
from PySide6.QtGui import QColor, QDesktopServices, QImage, QResizeEvent, QTextCursor, QTextDocument
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QSplitter,
    QTextBrowser,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.analysis.background import Newest
from ui.help.pages_of import PAGES, page_path, slug
from ui.help.reading import set_page
from ui.theme import tokens
from ui.words import tr

_SIZE = (940, 640)
_MARGIN = 60
_USUAL_WIDTH, _LEAST_WIDTH = 620, 200
_PAUSE_MS = 120


class PageView(QTextBrowser):
    """A page of Markdown with its pictures no wider than the view."""

    def __init__(self) -> None:
        super().__init__()
        self._page = page_path(PAGES[0][0])
        self._pictures: list[str] = []
        self._fitted = _USUAL_WIDTH
        self._scaler = Newest("pictures", self)
        self._scaler.done.connect(self._take_pictures)
        self._pause = QTimer(self, singleShot=True, interval=_PAUSE_MS)
        self._pause.timeout.connect(self._fit)
        self.setOpenLinks(False)
        self.document().setDocumentMargin(18)

    def show_page(self, page: str) -> None:
        """Show a page by its key."""
        self._page = page_path(page)
        text = self._page.read_text(encoding="utf-8")
        self._pictures = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)
        self.document().setMarkdown(text, QTextDocument.MarkdownFeature.MarkdownDialectGitHub)
        set_page(self.document(), QColor(tokens().border_strong))
        self.moveCursor(QTextCursor.MoveOperation.Start)
        self.verticalScrollBar().setValue(0)

    def find_on(self, words: str) -> bool:
        """Go to the next place with the words looked for, from the cursor on."""
        return bool(words) and self.find(words)

    def close_page(self) -> None:
        """End what runs in the background."""
        self._pause.stop()
        self._scaler.close()

    def loadResource(self, kind: int, name: QUrl | str) -> object:
        """Pictures shrink to the width there is."""
        url = QUrl(name)
        if kind == QTextDocument.ResourceType.ImageResource.value:
            return scaled(self._page.parent / url.toString(), self._fitted)
        return super().loadResource(kind, url)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Pictures get another size when that of the view has settled."""
        super().resizeEvent(event)
        self._pause.start()

    def _fit(self) -> None:
        """Have the pictures scaled to the width there is."""
        width, folder, names = max(self.viewport().width() - _MARGIN, _LEAST_WIDTH), self._page.parent, self._pictures
        if width != self._fitted:
            self._scaler.request(str(width), lambda: (width, {name: scaled(folder / name, width) for name in names}))

    def _take_pictures(self, _width: str, made: tuple[int, dict[str, QImage]]) -> None:
        """Show scaled pictures; what stood at the top stays there."""
        self._fitted, pictures = made
        document, top, bar = self.document(), self.cursorForPosition(QPoint(0, 0)), self.verticalScrollBar()
        before = self.cursorRect(top).top()
        for name, picture in pictures.items():
            document.addResource(QTextDocument.ResourceType.ImageResource.value, QUrl(name), picture)
        document.markContentsDirty(0, document.characterCount())
        bar.setValue(bar.value() + self.cursorRect(top).top() - before)


def scaled(path: Path, width: int) -> QImage:
    """A picture no wider than so many pixels."""
    picture = QImage(str(path))
    if picture.width() <= width:
        return picture
    return picture.scaledToWidth(width, Qt.TransformationMode.SmoothTransformation)


class GuideWindow(QDialog):
    """A page, its headings to jump to, and a search in it and in the other."""

    def __init__(self, parent: QWidget | None = None, page: str = "guide") -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Guide"))
        self.setWindowFlag(Qt.WindowType.WindowMaximizeButtonHint)
        self.resize(*_SIZE)
        self.pages = QComboBox()
        self.pages.setAccessibleName(tr("Page"))
        self.pages.setToolTip(tr("Guide or glossary"))
        for key, title in PAGES:
            self.pages.addItem(tr(title), key)
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Find in guide and glossary"))
        self.search.setAccessibleName(tr("Find in guide and glossary"))
        self.search.setToolTip(tr("Return goes to the next place"))
        self.search.setClearButtonEnabled(True)
        self.search.setMinimumWidth(220)
        self.search.returnPressed.connect(self.find_next)
        self.nothing = QLabel(tr("Nothing found"))
        self.nothing.setProperty("severity", "warning")
        self.nothing.hide()
        self.search.textEdited.connect(lambda _: self.nothing.hide())
        self.next = QToolButton()
        self.next.setText(tr("Next"))
        self.next.setToolTip(tr("Next place where the words stand"))
        self.next.clicked.connect(self.find_next)
        self.headings = QListWidget()
        self.headings.setAccessibleName(tr("Headings"))
        self.headings.setToolTip(tr("Go to a heading"))
        self.headings.currentRowChanged.connect(self._jump)
        self.view = PageView()
        self.view.setAccessibleName(tr("Page"))
        self.view.anchorClicked.connect(self._follow)
        self._blocks: list[int] = []
        self._lay_out()
        self.pages.currentIndexChanged.connect(lambda _: self._load())
        self.finished.connect(self.view.close_page)
        self.show_page(page)

    def changeEvent(self, event: QEvent) -> None:
        """Take the colours of the theme in use."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self.isVisible():
            place = self.view.verticalScrollBar().value()
            self._load()
            self.view.verticalScrollBar().setValue(place)

    def show_page(self, page: str) -> None:
        """Show a page by its key."""
        self.pages.setCurrentIndex(max(self.pages.findData(page), 0))
        self._load()

    def find_next(self) -> None:
        """Go to the next place with the words looked for: on this page, then on the other, then from the top again."""
        words = self.search.text().strip()
        found = self.view.find_on(words)
        for _ in range(self.pages.count() if words and not found else 0):
            self.pages.setCurrentIndex((self.pages.currentIndex() + 1) % self.pages.count())
            found = self.view.find_on(words)
            if found:
                break
        self.nothing.setVisible(bool(words) and not found)

    def show_term(self, term: str) -> None:
        """Show what a word of the glossary means."""
        self.show_page("glossary")
        block = self.view.document().begin()
        while block.isValid():
            if block.text().startswith(term.replace("_", "")):
                self._go_to(block.position())
                return
            block = block.next()

    def _lay_out(self) -> None:
        top = QHBoxLayout()
        top.addWidget(self.pages)
        top.addStretch(1)
        for widget in (self.nothing, self.search, self.next):
            top.addWidget(widget)
        split = QSplitter()
        split.addWidget(self.headings)
        split.addWidget(self.view)
        split.setStretchFactor(1, 1)
        split.setSizes([220, 720])
        column = QVBoxLayout(self)
        column.addLayout(top)
        column.addWidget(split, 1)

    def _load(self) -> None:
        self.view.show_page(self.pages.currentData())
        self._blocks = []
        self.headings.clear()
        block = self.view.document().begin()
        while block.isValid():
            level = block.blockFormat().headingLevel()
            if level in (1, 2, 3):
                self.headings.addItem("   " * (level - 1) + block.text())
                self._blocks.append(block.position())
            block = block.next()
        self.headings.setVisible(len(self._blocks) > 1)

    def _jump(self, row: int) -> None:
        if 0 <= row < len(self._blocks):
            self._go_to(self._blocks[row])

    def _go_to(self, position: int) -> None:
        cursor = self.view.textCursor()
        cursor.setPosition(position)
        self.view.setTextCursor(cursor)
        place = self.view.cursorRect(cursor).top() + self.view.verticalScrollBar().value()
        self.view.verticalScrollBar().setValue(place)

    def _jump_to(self, fragment: str) -> None:
        """Go to the heading that a link of the page names."""
        for row in range(self.headings.count()):
            if slug(self.headings.item(row).text()) == fragment:
                self.headings.setCurrentRow(row)

    def _follow(self, url: QUrl) -> None:
        if url.isRelative() and url.hasFragment():
            self._jump_to(url.fragment(QUrl.ComponentFormattingOption.FullyDecoded))
        elif url.isRelative() and self.pages.findData(Path(url.path()).stem) >= 0:
            self.show_page(Path(url.path()).stem)
        elif not url.isRelative():
            QDesktopServices.openUrl(url)
