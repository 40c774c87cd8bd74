"""What the window is about: the design as typed, the last good design, the choice of views, the results."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from PySide6.QtCore import QObject, Signal

from gearstudio.catalogue import METHOD_IDS, VARIANTS
from gearstudio.design import Design, design_mapping
from gearstudio.errors import Issue
from ui.judging import AT_ONCE_S, judge
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.results import VariantResult
    from gearstudio.theory.cones import PairGeometry
    from ui.judging import Case, Judging, Verdict

ALL = "all"


class Key(NamedTuple):
    """Which result: member, method, variant."""

    member: str
    method: str
    variant: str


@dataclass(frozen=True)
class Failure:
    """Why a variant could not be built: one line for the user, and the rest for Details."""

    message: str
    details: str
    cancelled: bool = False


class Session(QObject):
    """The state that the window shows; it knows no widget.

    ``draft`` maps dotted field names to values as typed, good or not. ``design`` and ``pair`` are the last
    good ones and change together; with ``judging`` they may follow an edit, or what was loaded, a little later. A
    result whose key is not in ``current`` belongs to an earlier design.

    Signals
    -------
    draft_replaced()
        Another design was loaded; every field may differ.
    issues_changed(object)
        tuple of Issue: everything wrong with the draft.
    design_changed(object)
        A new good Design; results of the previous one are stale.
    selection_changed()
        Member, method or variant.
    results_changed(object)
        The Key whose result, failure or progress changed, or None for all.
    document_changed()
        File name or unsaved state.
    """

    draft_replaced = Signal()
    issues_changed = Signal(object)
    design_changed = Signal(object)
    selection_changed = Signal()
    results_changed = Signal(object)
    document_changed = Signal()

    def __init__(self, parent: QObject | None = None, judging: Judging | None = None) -> None:
        super().__init__(parent)
        self._judging = judging
        self._case: Case | None = None
        self._afresh = True
        if judging is not None:
            judging.judged.connect(self._on_judged)
        self.design = Design()
        self.pair: PairGeometry | None = None
        self.draft: dict[str, Any] = flatten(self.design)
        self.issues: tuple[Issue, ...] = ()
        self.path: Path | None = None
        self.read_only = False
        self.member, self.method, self.variant = "wheel", ALL, "optimised"
        self.results: dict[Key, VariantResult] = {}
        self.current: set[Key] = set()
        self.failures: dict[Key, Failure] = {}
        self.building: Key | None = None
        self._saved = dict(self.draft)

    @property
    def unsaved(self) -> bool:
        """Whether the draft differs from what the file holds."""
        return self.draft != self._saved

    @property
    def title(self) -> str:
        """Name for the title bar."""
        name = self.path.name if self.path else str(self.draft.get("name") or tr("Untitled"))
        return tr("{name} (read-only)", name=name) if self.read_only else name

    @property
    def visible_methods(self) -> tuple[str, ...]:
        """The methods that have a view, in order."""
        return METHOD_IDS if self.method == ALL else (self.method,)

    @property
    def visible_keys(self) -> tuple[Key, ...]:
        """The results that have a view, in order."""
        return tuple(Key(self.member, method, self.variant) for method in self.visible_methods)

    def edit(self, field: str, value: Any) -> None:
        """Take a value as typed; when the whole draft is good, it becomes the design."""
        if field in self.draft and _same(self.draft[field], value):
            return
        self.draft[field] = value
        self._judge(AT_ONCE_S)
        self.document_changed.emit()

    def load(self, design: Design, path: Path | None = None, *, saved: bool = True, read_only: bool = False) -> None:
        """Start afresh from another design; with ``saved`` it counts as unchanged, ``read_only`` keeps its file."""
        self._saved = flatten(design) if saved else {}
        self.path, self.read_only, self._afresh = path, read_only, True
        self.restore(flatten(design))

    def restore(self, draft: Mapping[str, Any]) -> None:
        """Take a whole draft back, as undo does; results stay until they are replaced."""
        self.draft = dict(draft)
        self.draft_replaced.emit()
        self._judge()
        self.document_changed.emit()

    def settle(self) -> None:
        """Wait until what was typed is judged, as before a design is written."""
        if self._case is not None:
            self._take(judge(nest(self.draft)))

    def announce(self) -> None:
        """Tell everything once more, for a window that has just been made."""
        self.draft_replaced.emit()
        self.issues_changed.emit(self.issues)
        self.selection_changed.emit()
        self.design_changed.emit(self.design)
        self.results_changed.emit(None)
        self.document_changed.emit()

    def mark_saved(self, path: Path, design: Design) -> None:
        """Remember that a file now holds this design."""
        self.path, self.read_only, self._saved = path, False, flatten(design)
        self.document_changed.emit()

    def select(self, *, member: str | None = None, method: str | None = None, variant: str | None = None) -> None:
        """Change what the views show."""
        before = self.member, self.method, self.variant
        self.member, self.method, self.variant = member or self.member, method or self.method, variant or self.variant
        if before != (self.member, self.method, self.variant):
            self.selection_changed.emit()

    def missing_keys(self) -> tuple[Key, ...]:
        """What remains to be built for the chosen member, the visible ones first."""
        every = [Key(self.member, method, variant) for variant in VARIANTS for method in METHOD_IDS]
        ordered = dict.fromkeys([*self.visible_keys, *every])
        return tuple(key for key in ordered if key not in self.current and key not in self.failures)

    def put_result(self, design: Design, result: VariantResult) -> None:
        """Take a result, unless the design has moved on."""
        key = Key(result.member, result.method, result.variant)
        if design is self.design or design == self.design:
            self.results[key] = result
            self.current.add(key)
            self.failures.pop(key, None)
        self._settle(key)

    def put_failure(self, design: Design, key: Key, failure: Failure) -> None:
        """Note that a variant could not be built; an older result of it is dropped."""
        if design is self.design or design == self.design:
            self.failures[key] = failure
            self.results.pop(key, None)
            self.current.discard(key)
        self._settle(key)

    def put_cancelled(self, design: Design, key: Key) -> None:
        """Note that the user stopped a build; an older result stays, marked as such."""
        if design == self.design:
            self.failures[key] = Failure(tr("Cancelled; Rebuild builds it"), "", cancelled=True)
        self._settle(key)

    def put_building(self, key: Key | None) -> None:
        """Note which variant the worker is at, None for none."""
        before, self.building = self.building, key
        for changed in {before, key} - {None}:
            self.results_changed.emit(changed)

    def forget_results(self, keys: Iterable[Key] | None = None) -> None:
        """Treat results as stale, so that they are built again (None: all of them)."""
        chosen = set(keys) if keys is not None else set(self.current) | set(self.failures)
        self.current -= chosen
        for key in chosen:
            self.failures.pop(key, None)
        self.results_changed.emit(None)

    def _settle(self, key: Key) -> None:
        if self.building == key:
            self.building = None
        self.results_changed.emit(key)

    def _judge(self, patience_s: float = 0.0) -> None:
        if self._judging is None:
            self._take(judge(nest(self.draft)))
            return
        self._case = self._judging.take(nest(self.draft))
        verdict = self._case.wait(patience_s)
        if verdict is not None:
            self._take(verdict)

    def _on_judged(self, case: Case) -> None:
        """The newest case counts; one that broke down does so again here, where it is told."""
        if case is self._case:
            self._take(case.verdict or judge(nest(self.draft)))

    def _take(self, verdict: Verdict) -> None:
        self._case = None
        design, pair = verdict.design, verdict.pair
        if verdict.issues != self.issues:
            self.issues = verdict.issues
            self.issues_changed.emit(self.issues)
        if design is not None and pair is not None and (self._afresh or design != self.design):
            if self._afresh:
                self.results.clear()
            self.design, self.pair, self._afresh = design, pair, False
            self.current.clear()
            self.failures.clear()
            self.design_changed.emit(design)


def flatten(design: Design) -> dict[str, Any]:
    """A design as dotted names and values: ``{"pair.pinion_teeth": 17, ...}``."""
    flat: dict[str, Any] = {}

    def walk(prefix: str, values: Mapping[str, Any]) -> None:
        for name, value in values.items():
            if isinstance(value, Mapping):
                walk(f"{prefix}{name}.", value)
            else:
                flat[prefix + name] = value

    walk("", design_mapping(design))
    return flat


def nest(draft: Mapping[str, Any]) -> dict[str, Any]:
    """Dotted names back to the tables of a design file; None, an emptied optional field, is left out."""
    data: dict[str, Any] = {}
    for dotted, value in draft.items():
        *tables, name = dotted.split(".")
        target = data
        for table in tables:
            target = target.setdefault(table, {})
        if value is not None:
            target[name] = value
    return data


def _same(one: Any, other: Any) -> bool:
    return type(one) is type(other) and one == other
