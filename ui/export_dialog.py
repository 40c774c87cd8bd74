"""What to export, as which files, and where to; the last choices are remembered."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gearstudio.catalogue import METHOD_IDS, VARIANTS
from gearstudio.formats import FORMATS
from gearstudio.jobs import CONSTRUCTIONS, ExportJob
from ui.export_options import OptionsPanel
from ui.fields import set_severity
from ui.formatting import CONSTRUCTION_TITLES, MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES
from ui.words import tr

if TYPE_CHECKING:
    from ui.session import Session

PAIR = "pair"
SUBJECTS = {**MEMBER_TITLES, PAIR: "Pair in mesh"}
PART_TITLES = {"flanks": "Working flanks", "tooth": "One tooth", "gear": "Whole gear"}
FORMAT_TITLES = {
    "step": ("STEP", "names, colours, product structure"),
    "iges": ("IGES", "surfaces, for older programs"),
    "brep": ("BREP", "the CAD kernel's own"),
    "stl": ("STL", "triangles alone"),
    "3mf": ("3MF", "triangles, for printing"),
    "glb": ("GLB", "triangles in colour, for viewers"),
}
CHORD_SHARE = 1e-4
"""Of the outer cone distance, where the tolerance of triangles is left empty."""
SETTINGS = "export"
_OPTIONS_WIDTH = 300


class ExportDialog(QDialog):
    """Starts with what the window shows, and with part, files and folder as chosen the last time."""

    def __init__(
        self,
        session: Session,
        folder: str,
        parent: QWidget | None = None,
        settings: QSettings | None = None,
        mode: str = "flanks",
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Export"))
        self._session, self._settings = session, settings
        self._member = _combo(SUBJECTS, PAIR if mode == "pair" else session.member)
        self._part = _combo({part: PART_TITLES.get(part, part) for part in FORMATS}, self._remembered_part(mode))
        self._method = _combo({m: METHOD_TITLES[m] for m in METHOD_IDS}, session.visible_methods[0])
        self._variant = _combo({v: VARIANT_TITLES[v] for v in VARIANTS}, session.variant)
        self._construction = _combo(
            {c: CONSTRUCTION_TITLES.get(c, c) for c in CONSTRUCTIONS}, self._last("construction", CONSTRUCTIONS[0])
        )
        self._formats = {name: QCheckBox(FORMAT_TITLES[name][0]) for name in FORMAT_TITLES}
        pair = session.pair
        self.options = OptionsPanel(None if pair is None else CHORD_SHARE * pair.wheel.outer_cone_distance)
        self.options.set_choices({name: self._last(name, "") for name in self.options.choices()})
        self._record = QCheckBox(tr("Keep a record of the check beside each file"))
        self._record.setToolTip(tr("What was made and what was found, for “gearstudio verify”"))
        self._record.setChecked(self._last("record", "no") == "yes")
        self._folder = QLineEdit(self._last("folder", "") or folder)
        self._folder.setAccessibleName(tr("Folder"))
        self._folder.setToolTip(tr("Where the files are written"))
        self._files = QLabel()
        self._files.setProperty("role", "muted")
        self._files.setWordWrap(True)
        self._lay_out()
        chosen = self._last("formats", "step").split(",")
        for name, box in self._formats.items():
            box.setChecked(name in chosen)
            box.toggled.connect(self._refresh)
        for combo in (self._member, self._part):
            combo.currentIndexChanged.connect(self._refresh)
        self._folder.textChanged.connect(self._refresh)
        self.options.changed.connect(self._refresh)
        self._refresh()
        self.resize(max(self.sizeHint().width(), 760), 600)

    @property
    def formats(self) -> tuple[str, ...]:
        """The files that are ticked and offered for the part."""
        return tuple(name for name, box in self._formats.items() if box.isChecked() and box.isEnabled())

    def job(self) -> ExportJob:
        """What was asked for."""
        return ExportJob(
            design=self._session.design,
            member=self._member.currentData(),
            part=self._part.currentData(),
            method=self._method.currentData(),
            variant=self._variant.currentData(),
            formats=self.formats,
            directory=Path(self._folder.text().strip()).expanduser(),
            construction=self._construction.currentData(),
            options=self.options.options(),
            records=self._record.isChecked(),
        )

    def accept(self) -> None:
        """Remember the choices and close."""
        if self._settings is not None:
            values = {
                "part": self._part.currentData(),
                "construction": self._construction.currentData(),
                "formats": ",".join(name for name, box in self._formats.items() if box.isChecked()),
                "folder": self._folder.text().strip(),
                "record": "yes" if self._record.isChecked() else "no",
                **self.options.choices(),
            }
            for name, value in values.items():
                self._settings.setValue(f"{SETTINGS}/{name}", value)
        super().accept()

    # ---- parts -----------------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        browse = QPushButton(tr("Browse…"))
        browse.setAutoDefault(False)
        browse.setToolTip(tr("Folder for the exported files"))
        browse.clicked.connect(self._browse)
        form = QFormLayout()
        form.setSpacing(8)
        rows = (
            (tr("Export"), self._member, tr("The member, or both where they mesh")),
            (tr("Part"), self._part, tr("What of it")),
            (tr("Method"), self._method, tr("The construction whose surfaces are written")),
            (tr("Variant"), self._variant, tr("As the paper has it, or refined until it meets the tolerance")),
            (tr("Construction"), self._construction, tr("How a whole gear is put together")),
        )
        for title, editor, tip in rows:
            editor.setAccessibleName(title)
            editor.setToolTip(tip)
            form.addRow(title, editor)
        form.addRow(tr("Files"), self._format_grid())
        heading = QLabel(tr("How they are written"))
        heading.setProperty("role", "heading")
        right = QVBoxLayout()
        right.setSpacing(6)
        right.addWidget(heading)
        right.addWidget(self.options, 1)
        self.options.setMinimumWidth(_OPTIONS_WIDTH)
        columns = QHBoxLayout()
        columns.setSpacing(24)
        columns.addLayout(form, 1)
        columns.addLayout(right, 1)
        below = QFormLayout()
        below.setSpacing(8)
        below.addRow(tr("Folder"), _side_by_side(self._folder, browse))
        below.addRow("", self._record)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self._export = buttons.addButton(tr("Export"), QDialogButtonBox.ButtonRole.AcceptRole)
        self._export.setDefault(True)
        self._export.setToolTip(tr("Write the files and check them"))
        buttons.button(QDialogButtonBox.StandardButton.Cancel).setToolTip(tr("Close without writing"))
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(12)
        layout.addLayout(columns, 1)
        layout.addLayout(below)
        layout.addWidget(self._files)
        layout.addWidget(buttons)

    def _format_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(5)
        for row, (name, box) in enumerate(self._formats.items()):
            words = QLabel(tr(FORMAT_TITLES[name][1]))
            box.setToolTip(words.text())
            words.setProperty("role", "muted")
            grid.addWidget(box, row, 0)
            grid.addWidget(words, row, 1)
        grid.setColumnStretch(1, 1)
        return grid

    # ---- what goes together ------------------------------------------------------------------------------

    def _refresh(self) -> None:
        member, part = self._member.currentData(), self._part.currentData()
        self._part.setEnabled(member != PAIR)
        if member == PAIR and part != "gear":
            self._part.setCurrentIndex(self._part.findData("gear"))
            return
        for name, box in self._formats.items():
            box.setEnabled(name in FORMATS[part])
        self._construction.setEnabled(part == "gear")
        self.options.show_formats(self.formats)
        names = ", ".join(f"{member}-{part}.{name}" for name in self.formats)
        problem = self.options.problem() or ("" if names else tr("Choose a file format"))
        if not problem and not self._folder.text().strip():
            problem = tr("Choose a folder")
        set_severity(self._folder, "" if self._folder.text().strip() else "error")
        self._files.setText(problem or tr("Writes {names}", names=names))
        self._export.setEnabled(not problem)

    def _remembered_part(self, mode: str) -> str:
        part = self._last("part", "flanks") if mode == "flanks" else "gear"
        return part if part in FORMATS else next(iter(FORMATS))

    def _last(self, name: str, default: str) -> str:
        if self._settings is None:
            return default
        return str(self._settings.value(f"{SETTINGS}/{name}", default) or default)

    def _browse(self) -> None:
        folder = QFileDialog.getExistingDirectory(self, tr("Folder for the exported files"), self._folder.text())
        if folder:
            self._folder.setText(folder)


def _combo(titles: dict[str, str], chosen: str) -> QComboBox:
    combo = QComboBox()
    for identifier, title in titles.items():
        combo.addItem(tr(title), identifier)
    combo.setCurrentIndex(max(combo.findData(chosen), 0))
    return combo


def _side_by_side(wide: QWidget, narrow: QWidget) -> QHBoxLayout:
    row = QHBoxLayout()
    row.addWidget(wide, 1)
    row.addWidget(narrow)
    return row
