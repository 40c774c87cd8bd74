"""Solids of whole gears for the window: asked of the CAD process, meshed in a thread, kept until they are replaced."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.analysis.background import Newest
from ui.debounce import Debounce
from ui.session import Failure, Key, Session
from ui.words import tr

if TYPE_CHECKING:
    from gearstudio.design import Design
    from gearstudio.jobs import GearJob, Job
    from gearstudio.results import SolidResult
    from ui.runner import JobRunner
    from ui.solid_layers import PlacedGear

REST_MS = 500
"""Solids take seconds: after an edit they wait longer than the flanks do."""


@dataclass(frozen=True, eq=False)
class Built:
    """A solid as it was made for a design, with its meshes in the gear's own frame."""

    design: Design
    result: SolidResult
    gear: PlacedGear

    @property
    def largest_um(self) -> float:
        """Largest deviation of the flanks [µm]."""
        return float(abs(self.gear.fine.deviation_um).max(initial=1e-9))


@dataclass(frozen=True)
class Progress:
    """What the CAD process is doing for a solid, and how far it is (0 to 1)."""

    stage: str
    fraction: float


class Solids(QObject):
    """Keeps the wanted solids up to date with the session's design, through a runner.

    Signals
    -------
    changed()
        A result, failure or progress.
    settled()
        Every wanted solid is there, or has failed.
    """

    changed = Signal()
    settled = Signal()

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner: JobRunner | None = None
        self.automatic = True
        self.construction = "assemble"
        self.wanted: tuple[Key, ...] = ()
        self.built: dict[Key, Built] = {}
        self.failures: dict[Key, tuple[Design, Failure]] = {}
        self._awaited: dict[Key, GearJob] = {}
        self._progress: dict[Key, Progress] = {}
        self._to_mesh: dict[Key, tuple[Design, SolidResult]] = {}
        self._mesher = Newest("meshes", self)
        self._mesher.done.connect(self._on_meshed)
        self._mesher.failed.connect(self._on_mesh_failed)
        self._rest = Debounce(REST_MS, self)
        self._rest.settled.connect(self._build_if_automatic)
        session.design_changed.connect(self._on_design_changed)

    def use(self, runner: JobRunner) -> None:
        """Work through this runner from now on."""
        if runner is self._runner:
            return
        self._runner = runner
        runner.job_started.connect(lambda job: self._on_progressed(job, "building", 0.0))
        runner.job_progressed.connect(self._on_progressed)
        runner.job_done.connect(self._on_done)
        runner.job_failed.connect(self._on_failed)
        runner.job_cancelled.connect(self._on_cancelled)
        self._build_if_automatic()

    def want(self, keys: Sequence[Key]) -> None:
        """Keep these solids up to date; none when no solid is in sight."""
        if tuple(keys) != self.wanted:
            self.wanted = tuple(keys)
            self._build_if_automatic()
            self.changed.emit()

    def is_current(self, key: Key) -> bool:
        """Whether the solid belongs to the design as it is now."""
        built = self.built.get(key)
        return (
            built is not None
            and same_shape(built.design, self._session.design)
            and built.result.construction == self.construction
        )

    def failure(self, key: Key) -> Failure | None:
        """Why the solid of the present design could not be built."""
        design, failure = self.failures.get(key, (None, None))
        return failure if design is not None and same_shape(design, self._session.design) else None

    def progress(self, key: Key) -> Progress | None:
        """What is being done for a solid; None when nothing is."""
        if key in self._to_mesh:
            return Progress("meshing", 0.98)
        if key in self._awaited:
            return self._progress.get(key, Progress(tr("waiting for the CAD kernel"), 0.0))
        return None

    @Slot()
    def build(self) -> None:
        """Build every wanted solid that is not current, also one that failed before."""
        for key in self.wanted:
            self.failures.pop(key, None)
        self._request()

    def set_automatic(self, automatic: bool) -> None:
        """Follow the design by itself, or wait for `build`."""
        self.automatic = automatic
        self._build_if_automatic()

    def set_construction(self, construction: str) -> None:
        """Choose how solids are made."""
        if construction != self.construction:
            self.construction = construction
            self.failures.clear()
            self._build_if_automatic()
            self.changed.emit()

    def close(self) -> None:
        """Let the thread end."""
        self._rest.cancel()
        self._mesher.close()

    def _on_design_changed(self) -> None:
        self._rest.push()
        self.changed.emit()

    def _build_if_automatic(self) -> None:
        if self.automatic:
            self._request()

    def _request(self) -> None:
        if self._runner is None or self._session.pair is None:
            return
        from gearstudio.jobs import GearJob

        design = self._session.design
        missing = [key for key in self.wanted if not self.is_current(key) and self.failure(key) is None]
        jobs = {key: GearJob(design, *key, construction=self.construction) for key in missing}
        if all(self._awaited.get(key) == job or self._is_being_meshed(key) for key, job in jobs.items()):
            return
        self._awaited, self._progress = jobs, {}
        self._runner.submit(tuple(jobs.values()))
        self.changed.emit()

    def _is_being_meshed(self, key: Key) -> bool:
        waiting = self._to_mesh.get(key)
        return waiting is not None and same_shape(waiting[0], self._session.design)

    # ---- answers ---------------------------------------------------------------------------------------

    def _key(self, job: Job) -> Key | None:
        return Key(job.member, job.method, job.variant) if job.purpose == "solid" else None  # type: ignore[attr-defined]

    def _on_progressed(self, job: Job, stage: str, fraction: float) -> None:
        key = self._key(job)
        if key is not None:
            self._progress[key] = Progress(stage, fraction)
            self.changed.emit()

    def _on_done(self, job: Job, result: SolidResult) -> None:
        key = self._key(job)
        if key is None:
            return
        self._awaited.pop(key, None)
        self._to_mesh[key] = (job.design, result)  # type: ignore[attr-defined]
        waiting = dict(self._to_mesh)
        self._mesher.request(waiting, lambda: {k: meshed(*made) for k, made in waiting.items()})
        self.changed.emit()

    def _on_meshed(self, waiting: dict[Key, tuple[Design, SolidResult]], made: dict[Key, Built]) -> None:
        for key, built in made.items():
            if self._to_mesh.get(key) is waiting[key]:
                del self._to_mesh[key]
            self.built[key] = built
            self.failures.pop(key, None)
        self._tell()

    def _on_mesh_failed(self, waiting: dict[Key, tuple[Design, SolidResult]], text: str, details: str) -> None:
        for key, (design, _) in waiting.items():
            self._to_mesh.pop(key, None)
            self.failures[key] = (design, Failure(text, details))
        self._tell()

    def _on_failed(self, job: Job, text: str, details: str) -> None:
        key = self._key(job)
        if key is None:
            return
        self._awaited.pop(key, None)
        words = text.removeprefix(f"{key.method}: ")
        self.failures[key] = (job.design, Failure(words[:1].upper() + words[1:], details))  # type: ignore[attr-defined]
        self._tell()

    def _on_cancelled(self, job: Job) -> None:
        key = self._key(job)
        if key is None:
            return
        self._awaited.pop(key, None)
        failure = Failure(tr("Cancelled; Build builds it"), "", cancelled=True)
        self.failures[key] = (job.design, failure)  # type: ignore[attr-defined]
        self._tell()

    def _tell(self) -> None:
        self.changed.emit()
        if all(self.is_current(key) or self.failure(key) for key in self.wanted):
            self.settled.emit()


def same_shape(one: Design, other: Design) -> bool:
    """Whether two designs differ in nothing but their names."""
    return one is other or one == other or replace_name(one, other.name) == other


def replace_name(design: Design, name: str) -> Design:
    """The design under another name."""
    return design.model_copy(update={"name": name})


def meshed(design: Design, result: SolidResult) -> Built:
    """A solid with its meshes, fine and coarse."""
    from gearstudio.theory.cones import pair_geometry
    from ui.solid_layers import PlacedGear
    from ui.solid_scene import COARSE, FINE, gear_mesh

    member = pair_geometry(design).member(result.member)
    fine, coarse = (gear_mesh(result, member, fineness) for fineness in (FINE, COARSE))
    return Built(design, result, PlacedGear(result.member, fine, coarse))
