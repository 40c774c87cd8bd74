"""The guide and the glossary, to read beside the window."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices, QImage, QTextCursor, QTextDocument
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QSplitter,
    QTextBrowser,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ui.words import tr

HERE = Path(__file__).parent
_SIZE = (940, 640)
_MARGIN = 60
PAGES = (("guide", "Guide"), ("glossary", "Glossary"))


def pages_folder() -> Path:
    """Where the pages are: beside this file, or where links are not supported, in the project."""
    beside = HERE / "pages"
    return beside if beside.is_dir() else HERE.parents[1] / "docs"


class PageView(QTextBrowser):
    """A page of Markdown with its pictures no wider than the view."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self._folder = folder
        self.setOpenLinks(False)
        self.document().setDocumentMargin(18)

    def loadResource(self, kind: int, name: QUrl | str) -> object:
        """Pictures shrink to the width there is."""
        url = QUrl(name)
        if kind == QTextDocument.ResourceType.ImageResource.value:
            image = QImage(str(self._folder / url.toString()))
            return image.scaledToWidth(min(image.width(), max(self.viewport().width() - _MARGIN, 200)))
        return super().loadResource(kind, url)


class GuideWindow(QDialog):
    """A page, its headings to jump to, and a search in it."""

    def __init__(self, parent: QWidget | None = None, page: str = "guide") -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Guide"))
        self.resize(*_SIZE)
        self._folder = pages_folder()
        self.pages = QComboBox()
        self.pages.setAccessibleName(tr("Page"))
        self.pages.setToolTip(tr("Guide or glossary"))
        for key, title in PAGES:
            self.pages.addItem(tr(title), key)
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Find in the page"))
        self.search.setAccessibleName(tr("Find in the page"))
        self.search.setToolTip(tr("Return goes to the next place"))
        self.search.setClearButtonEnabled(True)
        self.search.returnPressed.connect(self.find_next)
        self.next = QToolButton()
        self.next.setText(tr("Next"))
        self.next.setToolTip(tr("Next place where the words stand"))
        self.next.clicked.connect(self.find_next)
        self.headings = QListWidget()
        self.headings.setAccessibleName(tr("Headings"))
        self.headings.setToolTip(tr("Go to a heading"))
        self.headings.currentRowChanged.connect(self._jump)
        self.view = PageView(self._folder)
        self.view.setAccessibleName(tr("Page"))
        self.view.anchorClicked.connect(self._follow)
        self._blocks: list[int] = []
        self._lay_out()
        self.pages.currentIndexChanged.connect(lambda _: self._load())
        self.show_page(page)

    def show_page(self, page: str) -> None:
        """Show a page by its key."""
        self.pages.setCurrentIndex(max(self.pages.findData(page), 0))
        self._load()

    def find_next(self) -> None:
        """Go to the next place with the words looked for, from the top after the last."""
        if self.search.text() and not self.view.find(self.search.text()):
            cursor = self.view.textCursor()
            cursor.setPosition(0)
            self.view.setTextCursor(cursor)
            self.view.find(self.search.text())

    def _lay_out(self) -> None:
        top = QHBoxLayout()
        top.addWidget(self.pages)
        top.addStretch(1)
        top.addWidget(self.search)
        top.addWidget(self.next)
        split = QSplitter()
        split.addWidget(self.headings)
        split.addWidget(self.view)
        split.setStretchFactor(1, 1)
        split.setSizes([220, 720])
        column = QVBoxLayout(self)
        column.addLayout(top)
        column.addWidget(split, 1)

    def _load(self) -> None:
        text = (self._folder / f"{self.pages.currentData()}.md").read_text(encoding="utf-8")
        self.view.document().setMarkdown(text, QTextDocument.MarkdownFeature.MarkdownDialectGitHub)
        self._blocks = []
        self.headings.clear()
        block = self.view.document().begin()
        while block.isValid():
            level = block.blockFormat().headingLevel()
            if level in (1, 2, 3):
                self.headings.addItem("   " * (level - 1) + block.text())
                self._blocks.append(block.position())
            block = block.next()
        self.view.moveCursor(QTextCursor.MoveOperation.Start)
        self.view.verticalScrollBar().setValue(0)

    def _jump(self, row: int) -> None:
        if 0 <= row < len(self._blocks):
            cursor = self.view.textCursor()
            cursor.setPosition(self._blocks[row])
            self.view.setTextCursor(cursor)
            place = self.view.cursorRect(cursor).top() + self.view.verticalScrollBar().value()
            self.view.verticalScrollBar().setValue(place)

    def _jump_to(self, fragment: str) -> None:
        """Go to the heading that a link of the page names."""
        for row in range(self.headings.count()):
            if self.headings.item(row).text().strip().lower().replace(",", "").replace(" ", "-") == fragment:
                self.headings.setCurrentRow(row)

    def _follow(self, url: QUrl) -> None:
        if url.isRelative() and url.hasFragment():
            self._jump_to(url.fragment())
            return
        key = Path(url.path()).stem
        if url.isRelative() and self.pages.findData(key) >= 0:
            self.show_page(key)
        elif not url.isRelative():
            QDesktopServices.openUrl(url)
