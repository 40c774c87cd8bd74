"""Carries measurements out: points of a file in a thread, those of a CAD model by the CAD process first."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal

from gearstudio.design import Design
from gearstudio.exchange.measured import is_model
from gearstudio.jobs import Job, SampleJob
from gearstudio.theory.cones import PairGeometry
from ui.analysis.background import Newest
from ui.analysis.measured_scene import measured_layers
from ui.analysis.measurement_data import ALL_TEETH, Measurement, Source, measured
from ui.analysis.measurement_view import pitch_chart, topography
from ui.charts.maps import MapData
from ui.charts.records import ChartData
from ui.layers import Layer

if TYPE_CHECKING:
    from gearstudio.exchange.measured_step import SampledModel
    from ui.analysis.cad_jobs import CadJobs

SAMPLING = 0.4
"""Part of the work that taking points of a model is."""


@dataclass(frozen=True)
class Against:
    """What points are compared with."""

    design: Design
    pair: PairGeometry
    member: str


@dataclass(frozen=True)
class Asked:
    """How: what the best fit may do, points along the face width of a model, and the tooth that is drawn."""

    fit: tuple[bool, bool]
    points_per_face: float
    tooth: int = ALL_TEETH


@dataclass(frozen=True)
class Drawn:
    """What is shown of one tooth or all."""

    tooth: int
    bars: MapData
    largest_um: float
    pitch: ChartData
    layers: tuple[Layer, ...]


def drawn(measurement: Measurement, tooth: int) -> Drawn:
    """Charts and layers of one tooth, or of all."""
    tooth = tooth if tooth in measurement.teeth else ALL_TEETH
    bars, largest = topography(measurement, tooth)
    return Drawn(tooth, bars, largest, pitch_chart(measurement), measured_layers(measurement, tooth))


class MeasurementWork(QObject):
    """One measurement at a time; the newest request wins.

    Signals
    -------
    measured(object, object)
        Measurement and Drawn.
    redrawn(object)
        Drawn, of another tooth.
    refused(str)
        Why the points cannot be used.
    cancelled()
    progressed(object)
        The part done, None when nothing is left to do.
    """

    measured = Signal(object, object)
    redrawn = Signal(object)
    refused = Signal(str)
    cancelled = Signal()
    progressed = Signal(object)
    _reported = Signal(float)

    def __init__(self, jobs: CadJobs, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._jobs = jobs
        self._sampling: SampleJob | None = None
        self._against: Against | None = None
        self._asked = Asked((True, True), 1.0)
        self.source: Source | None = None
        self.background = Newest("measurement", self)
        self.background.done.connect(self._on_done)
        self.background.failed.connect(lambda label, text, _details: self._is_wanted(label) and self.refused.emit(text))
        self.background.stopped.connect(lambda _label: self._end(self.cancelled.emit))
        self.background.idle.connect(lambda: self._sampling is None and self.progressed.emit(None))
        self._reported.connect(self._on_reported, Qt.ConnectionType.QueuedConnection)
        jobs.progressed.connect(lambda job, _stage, part: self._is_ours(job) and self.progressed.emit(SAMPLING * part))
        jobs.done.connect(self._on_sampled)
        jobs.failed.connect(lambda job, text, _d: self._is_ours(job) and self._end(lambda: self.refused.emit(text)))
        jobs.cancelled.connect(lambda job: self._is_ours(job) and self._end(self.cancelled.emit))

    @property
    def busy(self) -> bool:
        """Whether anything waits or is being done."""
        return self._sampling is not None or self.background.busy

    def open(self, path: Path | None) -> None:
        """Another file, or none; `request` measures it."""
        self.source = None if path is None else Source(path)

    def set_against(self, against: Against) -> None:
        """Compare with another member; the faces of a model are chosen anew."""
        self._against = against
        if self.source is not None and is_model(self.source.path):
            self.source = Source(self.source.path)

    def request(self, asked: Asked) -> None:
        """Measure the file, in place of what is being measured."""
        source, against, self._asked = self.source, self._against, asked
        if source is None or against is None:
            return
        self.progressed.emit(0.0)
        if is_model(source.path) and source.chunks is None:
            spacing = against.pair.member(against.member).face_width / asked.points_per_face
            self._sampling = SampleJob(against.design, against.member, source.path, spacing)
            self._jobs.submit(self._sampling)
            return
        self._sampling, begun = None, SAMPLING if is_model(source.path) else 0.0

        def report(_stage: str, part: float) -> None:
            self.background.go_on()
            self._reported.emit(begun + (1 - begun) * part)

        def work() -> tuple[Measurement, Drawn]:
            found = measured(against.design, against.pair, against.member, source, asked.fit, report)
            return found, drawn(found, asked.tooth)

        self.background.request((against, source.path), work)

    def redraw(self, measurement: Measurement, tooth: int) -> None:
        """Draw one tooth or all of a measurement."""
        self.background.request(None, lambda: drawn(measurement, tooth))

    def cancel(self) -> None:
        """End what is being done."""
        if self._sampling is not None:
            self._jobs.cancel()
        self.background.cancel()

    def close(self) -> None:
        """End the thread."""
        self.background.close()

    def _is_ours(self, job: Job) -> bool:
        return self._sampling is not None and job == self._sampling

    def _is_wanted(self, label: object) -> bool:
        return self.source is not None and label == (self._against, self.source.path)

    def _end(self, tell: Callable[[], object]) -> None:
        self._sampling = None
        self.progressed.emit(None)
        tell()

    def _on_reported(self, part: float) -> None:
        if self.background.busy:
            self.progressed.emit(part)

    def _on_sampled(self, job: Job, model: SampledModel) -> None:
        if self._is_ours(job) and self.source is not None:
            faces = (model.flank_faces, model.faces)
            self.source = replace(self.source, chunks=(model.points,), shift=model.shift, faces=faces)
            self.request(self._asked)

    def _on_done(self, label: object, outcome: object) -> None:
        if isinstance(outcome, Drawn):
            self.redrawn.emit(outcome)
        elif self._is_wanted(label):
            measurement, made = outcome  # type: ignore[misc]
            self.source = measurement.source
            self.measured.emit(measurement, made)
