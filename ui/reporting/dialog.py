"""What goes into the report, what it will look like, and where it is saved."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings, Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gearstudio.catalogue import MEMBERS
from gearstudio.report.sections import SECTION_KEYS, SECTIONS
from ui.keyboard import tab_as_read
from ui.language import spoken
from ui.mnemonics import separate
from ui.preferences import LANGUAGES
from ui.reporting.pages_view import PagesView
from ui.words import told, tr

if TYPE_CHECKING:
    from gearstudio.report.job import Reported

_SIZE = (1040, 660)
_SETTINGS = "report"


@dataclass(frozen=True)
class ReportState:
    """What is chosen and shown.

    Attributes
    ----------
    place : int
        How far the pages are scrolled down, in pixels.
    troubles : tuple of str
        Lines of the warning over the pages.
    stage : (str, float) or None
        What is being done, and which part of it is; None at rest.
    """

    ticked: frozenset[str]
    member: str
    language: str
    made: Reported | None
    place: int
    troubles: tuple[str, ...]
    stage: tuple[str, float] | None


class ReportDialog(QDialog):
    """Chooses sections, shows the pages, saves the PDF; the work itself is its owner's.

    Signals
    -------
    wanted(object, str, str)
        Sections, the member whose maps are drawn, and the language: make the report.
    cancelled()
        Stop making it.
    saved(object, object)
        A path and the PDF to write there.
    """

    wanted = Signal(object, str, str)
    cancelled = Signal()
    saved = Signal(object, object)

    def __init__(self, name: str, member: str, folder: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Report"))
        self.setWindowFlag(Qt.WindowType.WindowMaximizeButtonHint)
        self.resize(*_SIZE)
        self._name, self._folder = name, folder
        self._made: Reported | None = None
        self._troubles: tuple[str, ...] = ()
        self._stage: tuple[str, float] | None = None
        self._boxes = self._section_boxes()
        self.member = QComboBox()
        self.member.setAccessibleName(tr("Maps and charts of"))
        self.member.setToolTip(tr("The member that is drawn"))
        for one in MEMBERS:
            self.member.addItem(tr(one.capitalize()), one)
        self.member.setCurrentIndex(MEMBERS.index(member) if member in MEMBERS else 0)
        self.language = QComboBox()
        self.language.setAccessibleName(tr("Language of the report"))
        self.language.setToolTip(tr("The language that the report is written in"))
        for code, title in LANGUAGES:
            if code:
                self.language.addItem(title, code)
        self.language.setCurrentIndex(self.language.findData(spoken()))
        self.pages = PagesView()
        self.progress = QProgressBar()
        self.progress.setTextVisible(False)
        self.progress.setRange(0, 100)
        self.stage = QLabel()
        self.stage.setProperty("role", "muted")
        self.stage.setWordWrap(True)
        self.trouble = QLabel()
        self.trouble.setProperty("severity", "warning")
        self.trouble.setWordWrap(True)
        self.trouble.hide()
        self.make = QPushButton(tr("&Update preview"))
        self.make.setToolTip(tr("Compute the report of the design as it is now"))
        self.stop = QPushButton(tr("&Stop"))
        self.stop.setToolTip(tr("Stop making the report"))
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        self.save = self.buttons.addButton(tr("&Save PDF…"), QDialogButtonBox.ButtonRole.AcceptRole)
        self.save.setEnabled(False)
        self.save.setToolTip(tr("Save the report"))
        self.buttons.button(QDialogButtonBox.StandardButton.Close).setToolTip(tr("Close the report"))
        separate((self.save, self.make, self.stop))
        self.make.clicked.connect(self._make)
        self.stop.clicked.connect(self.cancelled)
        self.save.clicked.connect(self._save)
        self.buttons.rejected.connect(self.reject)
        self._lay_out()
        self._restore()
        self._rest(tr("Choose what goes in, then Update preview."))

    @property
    def sections(self) -> tuple[str, ...]:
        """Keys of the ticked sections that there can be, in the order of the report."""
        return tuple(key for key in SECTION_KEYS if self._boxes[key].isChecked() and self._boxes[key].isEnabled())

    def keep_state(self) -> ReportState:
        """For `take_state` of another one."""
        return ReportState(
            frozenset(key for key, box in self._boxes.items() if box.isChecked()),
            self.member.currentData(),
            self.language.currentData(),
            self._made,
            self.pages.verticalScrollBar().value(),
            self._troubles,
            self._stage,
        )

    def take_state(self, state: ReportState) -> None:
        """Show the same; what was said is said in the present language."""
        for key, box in self._boxes.items():
            box.setChecked(key in state.ticked)
        self.member.setCurrentIndex(self.member.findData(state.member))
        self.language.setCurrentIndex(self.language.findData(state.language))
        troubles = tuple(told(trouble) for trouble in state.troubles)
        if state.made is not None:
            self.show_report(state.made)
            self.pages.scroll_to(state.place)
        elif troubles:
            self.pages.say("\n".join(troubles))
        self._warn(*troubles)
        if state.stage is not None:
            self.show_progress(*state.stage)

    def show_measured(self, name: str) -> None:
        """There are measured points of a file, or none."""
        box = self._boxes["measurement"]
        summary = tr(next(section.summary for section in SECTIONS if section.key == "measurement"))
        box.setEnabled(bool(name))
        box.setToolTip(f"{summary}: {name}" if name else tr("Open measured points on the page Measurement first"))

    def show_progress(self, stage: str, fraction: float) -> None:
        """The report is being made."""
        self._warn()
        self._stage = stage, fraction
        said = told(stage)
        self.stage.setText(said[:1].upper() + said[1:])
        self.progress.setValue(round(100 * fraction))
        self._busy(True)

    def show_report(self, made: Reported) -> None:
        """The report is there."""
        self._made = made
        self.pages.show_pages(made.pages)
        self.stage.setText(tr("{count} pages, {size:.1f} MB", count=len(made.pages), size=len(made.pdf) / 1e6))
        self._busy(False)
        self._warn(*(told(warning) for warning in made.warnings))

    def show_failure(self, text: str) -> None:
        """The report could not be made, or not be saved; the last one stays, and the reason until it is made again."""
        if self._made is None:
            self.pages.say(text)
        self.stage.clear()
        self._warn(text)
        self._busy(False)

    def show_stale(self) -> None:
        """The design is another one than that of the pages shown."""
        if self._made is not None and not self.progress.isVisible():
            self._warn(tr("Out of date: the design was changed after these pages were made. Update the preview."))

    def _warn(self, *lines: str) -> None:
        self._troubles = lines
        self.trouble.setText("\n".join(lines))
        self.trouble.setVisible(bool(lines))

    def reject(self) -> None:
        """Closing stops what is being made."""
        if self.progress.isVisible():
            self.cancelled.emit()
        self._remember()
        super().reject()

    def _section_boxes(self) -> dict[str, QCheckBox]:
        boxes = {}
        for section in SECTIONS:
            box = QCheckBox(tr(section.title))
            box.setToolTip(tr(section.summary))
            box.toggled.connect(self._on_toggled)
            boxes[section.key] = box
        return boxes

    def _lay_out(self) -> None:
        choices = QVBoxLayout()
        heading = QLabel(tr("Chapters"))
        heading.setProperty("role", "heading")
        choices.addWidget(heading)
        for box in self._boxes.values():
            choices.addWidget(box)
        form = QFormLayout()
        form.addRow(tr("Maps and charts of"), self.member)
        form.addRow(tr("Language"), self.language)
        choices.addSpacing(8)
        choices.addLayout(form)
        choices.addSpacing(8)
        choices.addWidget(self.make)
        choices.addWidget(self.stop)
        choices.addStretch(1)
        top = QHBoxLayout()
        top.addLayout(choices)
        shown = QVBoxLayout()
        shown.addWidget(self.trouble)
        shown.addWidget(self.pages, 1)
        top.addLayout(shown, 1)
        bottom = QHBoxLayout()
        bottom.addWidget(self.stage, 1)
        bottom.addWidget(self.progress)
        bottom.addWidget(self.buttons)
        column = QVBoxLayout(self)
        column.addLayout(top, 1)
        column.addLayout(bottom)
        boxes = self._boxes.values()
        tab_as_read(self, *boxes, self.member, self.language, self.make, self.stop, self.pages, self.buttons)

    def _rest(self, text: str) -> None:
        self.pages.say(text)
        self._busy(False)

    def _busy(self, busy: bool) -> None:
        self._stage = self._stage if busy else None
        self.progress.setVisible(busy)
        self.stop.setEnabled(busy)
        self.make.setEnabled(not busy and bool(self.sections))
        self.save.setEnabled(not busy and self._made is not None)

    def _on_toggled(self) -> None:
        if hasattr(self, "progress"):
            self.make.setEnabled(bool(self.sections) and not self.progress.isVisible())

    def _make(self) -> None:
        self._remember()
        self.wanted.emit(self.sections, self.member.currentData(), self.language.currentData())

    def _save(self) -> None:
        if self._made is None:
            return
        start = str(Path(self._folder) / f"{self._name}.pdf")
        name, _ = QFileDialog.getSaveFileName(self, tr("Save the report"), start, tr("PDF files (*.pdf)"))
        if name:
            path = Path(name if name.lower().endswith(".pdf") else f"{name}.pdf")
            self.saved.emit(path, self._made.pdf)

    def _restore(self) -> None:
        left_out = str(QSettings().value(f"{_SETTINGS}/left_out") or "").split(",")
        for key, box in self._boxes.items():
            box.setChecked(key not in left_out)

    def _remember(self) -> None:
        left_out = [key for key in SECTION_KEYS if not self._boxes[key].isChecked()]
        QSettings().setValue(f"{_SETTINGS}/left_out", ",".join(left_out))
