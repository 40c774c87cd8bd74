"""Which flanks to export, and where to."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from gearstudio.catalogue import MEMBERS, METHOD_IDS, VARIANTS
from ui.formatting import MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES
from ui.session import Session

if TYPE_CHECKING:
    from gearstudio.jobs import ExportJob


class ExportDialog(QDialog):
    """Asks for member, method, variant and folder; starts with what the window shows."""

    def __init__(self, session: Session, folder: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Export flanks")
        self.setMinimumWidth(460)
        self._session = session
        self._member = _combo(MEMBERS, MEMBER_TITLES, session.member)
        self._method = _combo(METHOD_IDS, METHOD_TITLES, session.visible_methods[0])
        self._variant = _combo(VARIANTS, VARIANT_TITLES, session.variant)
        self._folder = QLineEdit(folder)
        browse = QPushButton("Browse…")
        browse.setAutoDefault(False)
        browse.clicked.connect(self._browse)
        place = QHBoxLayout()
        place.addWidget(self._folder, 1)
        place.addWidget(browse)
        form = QFormLayout()
        form.setSpacing(8)
        for title, editor in (("Member", self._member), ("Method", self._method), ("Variant", self._variant)):
            form.addRow(title, editor)
        form.addRow("Folder", place)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        export = buttons.addButton("Export as STEP", QDialogButtonBox.ButtonRole.AcceptRole)
        export.setDefault(True)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._folder.textChanged.connect(lambda text: export.setEnabled(bool(text.strip())))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(16, 16, 16, 12)
        layout.setSpacing(14)
        layout.addLayout(form)
        layout.addWidget(buttons)

    def job(self) -> ExportJob:
        """What was asked for."""
        from gearstudio.jobs import ExportJob

        return ExportJob(
            design=self._session.design,
            member=self._member.currentData(),
            part="flanks",
            method=self._method.currentData(),
            variant=self._variant.currentData(),
            formats=("step",),
            directory=Path(self._folder.text().strip()).expanduser(),
        )

    def _browse(self) -> None:
        folder = QFileDialog.getExistingDirectory(self, "Folder for the exported files", self._folder.text())
        if folder:
            self._folder.setText(folder)


def _combo(identifiers: tuple[str, ...], titles: dict[str, str], chosen: str) -> QComboBox:
    combo = QComboBox()
    for identifier in identifiers:
        combo.addItem(titles[identifier], identifier)
    combo.setCurrentIndex(combo.findData(chosen))
    return combo
