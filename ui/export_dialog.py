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
from gearstudio.jobs import CONSTRUCTIONS, FORMATS, SOLID_FORMATS, ExportedFile, ExportJob
from ui.fields import set_severity
from ui.formatting import CONSTRUCTION_TITLES, MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES, number_text, parse_number

if TYPE_CHECKING:
    from ui.session import Session

PAIR = "pair"
SUBJECTS = {**MEMBER_TITLES, PAIR: "Pair in mesh"}
PART_TITLES = {"flanks": "Working flanks", "tooth": "One tooth", "gear": "Whole gear"}
FORMAT_TITLES = {
    "step": ("STEP", "AP242: names, colours, product structure"),
    "iges": ("IGES", "surfaces, for older programs"),
    "brep": ("BREP", "the CAD kernel's own"),
    "stl": ("STL", "triangles, binary"),
    "3mf": ("3MF", "triangles, for printing"),
    "glb": ("GLB", "triangles in colour, for viewers"),
}
CHORD_SHARE = 1e-4
"""Of the outer cone distance, where the tolerance of triangles is left empty."""
SETTINGS = "export"


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
        self.setWindowTitle("Export")
        self.setMinimumWidth(480)
        self._session, self._settings = session, settings
        self._member = _combo(SUBJECTS, PAIR if mode == "pair" else session.member)
        self._part = _combo({part: PART_TITLES.get(part, part) for part in FORMATS}, self._remembered_part(mode))
        self._method = _combo({m: METHOD_TITLES[m] for m in METHOD_IDS}, session.visible_methods[0])
        self._variant = _combo({v: VARIANT_TITLES[v] for v in VARIANTS}, session.variant)
        self._construction = _combo(
            {c: CONSTRUCTION_TITLES.get(c, c) for c in CONSTRUCTIONS}, self._last("construction", CONSTRUCTIONS[0])
        )
        self._formats = {name: QCheckBox(FORMAT_TITLES.get(name, (name.upper(), ""))[0]) for name in _all_formats()}
        self._chord = QLineEdit(self._last("chord", ""))
        self._folder = QLineEdit(self._last("folder", "") or folder)
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
        for line in (self._chord, self._folder):
            line.textChanged.connect(self._refresh)
        self._refresh()

    @property
    def formats(self) -> tuple[str, ...]:
        """The files that are ticked and offered for the part."""
        return tuple(name for name, box in self._formats.items() if box.isChecked() and box.isEnabled())

    @property
    def chord(self) -> float | None:
        """Chordal tolerance of triangles [mm]; None for the usual one.

        Raises
        ------
        ValueError
            What is typed is no length above 0.
        """
        text = self._chord.text().strip()
        value = parse_number(text) if text else None
        if value is None:
            return None
        if isinstance(value, str) or value <= 0:
            raise ValueError(text)
        return float(value)

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
            chord=self.chord if self._has_triangles else None,
        )

    def accept(self) -> None:
        """Remember the choices and close."""
        if self._settings is not None:
            values = {
                "part": self._part.currentData(),
                "construction": self._construction.currentData(),
                "formats": ",".join(name for name, box in self._formats.items() if box.isChecked()),
                "chord": self._chord.text().strip(),
                "folder": self._folder.text().strip(),
            }
            for name, value in values.items():
                self._settings.setValue(f"{SETTINGS}/{name}", value)
        super().accept()

    # ---- parts -----------------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        browse = QPushButton("Browse…")
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        form = QFormLayout()
        form.setSpacing(8)
        rows = (("Export", self._member), ("Part", self._part), ("Method", self._method), ("Variant", self._variant))
        for title, editor in (*rows, ("Construction", self._construction)):
            form.addRow(title, editor)
        form.addRow("Files", self._format_grid())
        pair = self._session.pair
        if pair is not None:
            usual = CHORD_SHARE * pair.wheel.outer_cone_distance
            self._chord.setPlaceholderText(number_text(float(f"{usual:.3g}")))
        self._chord.setToolTip("How far triangles may lie from the surfaces; leave it empty for the usual")
        self._chord.setMaximumWidth(110)
        form.addRow("Triangles within", _side_by_side(self._chord, QLabel("mm"), None))
        form.addRow("Folder", _side_by_side(self._folder, browse))
        form.addRow("", self._files)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self._export = buttons.addButton("Export", QDialogButtonBox.ButtonRole.AcceptRole)
        self._export.setDefault(True)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(14)
        layout.addLayout(form)
        layout.addWidget(buttons)

    def _format_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(5)
        for row, (name, box) in enumerate(self._formats.items()):
            words = QLabel(FORMAT_TITLES.get(name, ("", ""))[1])
            words.setProperty("role", "muted")
            grid.addWidget(box, row, 0)
            grid.addWidget(words, row, 1)
        grid.setColumnStretch(1, 1)
        return grid

    # ---- what goes together ------------------------------------------------------------------------------

    @property
    def _has_triangles(self) -> bool:
        return any(name not in SOLID_FORMATS for name in self.formats)

    def _refresh(self) -> None:
        member, part = self._member.currentData(), self._part.currentData()
        self._part.setEnabled(member != PAIR)
        if member == PAIR and part != "gear":
            self._part.setCurrentIndex(self._part.findData("gear"))
            return
        for name, box in self._formats.items():
            box.setEnabled(name in FORMATS[part])
        self._construction.setEnabled(part == "gear")
        self._chord.setEnabled(self._has_triangles)
        good = self._chord_is_good()
        set_severity(self._chord, "" if good else "error")
        names = ", ".join(f"{member}-{part}.{name}" for name in self.formats)
        self._files.setText(f"Writes {names}" if names else "Choose a file format")
        self._export.setEnabled(bool(names) and good and bool(self._folder.text().strip()))

    def _chord_is_good(self) -> bool:
        try:
            return not self._has_triangles or self.chord is None or self.chord > 0
        except ValueError:
            return False

    def _remembered_part(self, mode: str) -> str:
        part = self._last("part", "flanks") if mode == "flanks" else "gear"
        return part if part in FORMATS else next(iter(FORMATS))

    def _last(self, name: str, default: str) -> str:
        if self._settings is None:
            return default
        return str(self._settings.value(f"{SETTINGS}/{name}", default) or default)

    def _browse(self) -> None:
        folder = QFileDialog.getExistingDirectory(self, "Folder for the exported files", self._folder.text())
        if folder:
            self._folder.setText(folder)


def export_report(files: tuple[ExportedFile, ...]) -> tuple[str, str]:
    """What an export wrote: a line, and what was found on reading each file back."""
    names = ", ".join(f"{file.path.name} ({_size(file.size)})" for file in files)
    folder = files[0].path.parent if files else ""
    lines = [
        f"{file.path.name}: {file.check if file.check is not None else 'read back, flanks the same'}" for file in files
    ]
    return f"Wrote {names} to {folder}; read back and checked", "\n".join(lines)


def _size(size: int) -> str:
    return f"{size / 1e6:.1f} MB" if size >= 1e6 else f"{max(size / 1e3, 1):.0f} kB"


def _all_formats() -> tuple[str, ...]:
    return tuple(dict.fromkeys(name for names in FORMATS.values() for name in names))


def _combo(titles: dict[str, str], chosen: str) -> QComboBox:
    combo = QComboBox()
    for identifier, title in titles.items():
        combo.addItem(title, identifier)
    combo.setCurrentIndex(max(combo.findData(chosen), 0))
    return combo


def _side_by_side(*widgets: QWidget | None) -> QHBoxLayout:
    """Widgets in a row, the first one stretched; None takes what room is left."""
    row = QHBoxLayout()
    for index, widget in enumerate(widgets):
        if widget is None:
            row.addStretch(1)
        else:
            row.addWidget(widget, int(index == 0 and None not in widgets))
    return row
