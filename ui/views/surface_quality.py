"""Keeps the surface quality of the results in sight: computed in a thread, once for each result."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from gearstudio.errors import GeometryError
from ui.analysis.background import Newest
from ui.words import told

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import MemberGeometry
    from ui.views.quality import FlankQuality

Found = Mapping[str, "FlankQuality"] | str
"""What was found of a result by flank, or why there is nothing."""


class SurfaceQuality(QObject):
    """Answers at once with what is known, and says when there is more.

    Signals
    -------
    changed()
        Something that was asked for is there now.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._newest = Newest("surface quality", self)
        self._newest.done.connect(self._on_done)
        self._newest.failed.connect(self._on_failed)
        self._held: dict[int, tuple[VariantResult, Found]] = {}

    def of(self, results: Sequence[VariantResult], member: MemberGeometry) -> list[Found | None]:
        """What is known of each result; what is missing is asked for, what is no more asked for is forgotten."""
        alive = {id(result) for result in results}
        self._held = {key: held for key, held in self._held.items() if key in alive}
        missing = [result for result in results if id(result) not in self._held]
        if missing:
            self._newest.request(tuple(missing), lambda: _computed(missing, member))
        return [self._held[id(result)][1] if id(result) in self._held else None for result in results]

    def close(self) -> None:
        """Compute no more."""
        self._newest.close()

    def _on_done(self, asked: tuple[VariantResult, ...], found: list[Found]) -> None:
        for result, one in zip(asked, found, strict=True):
            self._held[id(result)] = (result, one)
        self.changed.emit()

    def _on_failed(self, asked: tuple[VariantResult, ...], text: str, _details: str) -> None:
        self._on_done(asked, [text] * len(asked))


def _computed(results: Sequence[VariantResult], member: MemberGeometry) -> list[Found]:
    from ui.views.quality import variant_quality

    found: list[Found] = []
    for result in results:
        try:
            found.append(variant_quality(result, member))
        except GeometryError as error:
            found.append(told(error))
    return found
