"""Keeps the section drawings of both blanks in the form up to date."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QObject

from gearstudio.catalogue import MEMBERS
from gearstudio.errors import GeometryError, Issue
from ui.blank_drawing import BlankDrawing
from ui.parameter_form import ParameterForm
from ui.session import Session
from ui.words import told, tr

GROUPS = {"pinion": "Pinion blank", "wheel": "Wheel blank"}
NOT_THIS = "These sizes make no blank; the field says why."


class Blanks(QObject):
    """A drawing in each section of blank fields: of the last good design, and dimmed while a field is wrong."""

    def __init__(self, session: Session, form: ParameterForm, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self.drawings = {member: BlankDrawing(member) for member in MEMBERS}
        for member, drawing in self.drawings.items():
            form.place_on_top(GROUPS[member], drawing)
        session.design_changed.connect(self.refresh)
        session.issues_changed.connect(self._on_issues)

    def refresh(self) -> None:
        """Draw the session's design."""
        from ui.blank_shape import blank_shape

        session = self._session
        if session.pair is None:
            return
        for member, drawing in self.drawings.items():
            try:
                drawing.show_shape(blank_shape(session.design, session.pair.member(member)), self._note(member))
            except GeometryError as error:
                drawing.show_shape(None, told(error))

    def _on_issues(self, _issues: Sequence[Issue]) -> None:
        for member, drawing in self.drawings.items():
            drawing.show_shape(drawing.shape, self._note(member))

    def _note(self, member: str) -> str:
        wrong = [i for i in self._session.issues if i.severity == "error" and i.field.startswith(f"blank.{member}.")]
        return tr(NOT_THIS) if wrong else ""
