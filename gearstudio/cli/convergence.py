"""``compare --convergence``: how the deviation of each method falls with its effort."""

from __future__ import annotations

from dataclasses import asdict
from functools import partial
from typing import TYPE_CHECKING, Any

from gearstudio.catalogue import METHOD_INFOS
from gearstudio.cli.output import Progress, table
from gearstudio.design import Design

if TYPE_CHECKING:
    from gearstudio.analysis.convergence import ConvergenceStudy

HEADINGS = ("Method", "count", "poles", "seconds", "max µm", "mean µm", "rms µm")


def studies(design: Design, member: str, progress: Progress) -> dict[str, ConvergenceStudy]:
    """The study of every method."""
    from gearstudio.analysis.convergence import convergence_point, convergence_study

    found = {}
    for number, info in enumerate(METHOD_INFOS):

        def told(stage: str, part: float, begun: int = number) -> None:
            progress(f"{member}, {stage}", (begun + part) / len(METHOD_INFOS))

        found[info.id] = convergence_study(info.id, partial(convergence_point, design, member, info.id), report=told)
    return found


def study_records(found: dict[str, ConvergenceStudy], tolerance_um: float) -> dict[str, Any]:
    """Studies as plain values, with the point at which each method has reached the tolerance."""
    from gearstudio.analysis.convergence import COUNTED

    records = {}
    for method, study in found.items():
        reached = study.reaching(tolerance_um)
        records[method] = {
            "counted": COUNTED[method],
            "points": [asdict(point) for point in study.points],
            "failures": {str(count): reason for count, reason in study.failures.items()},
            "order_in_poles": study.order("poles") if len(study.points) > 2 else None,
            "tolerance_um": tolerance_um,
            "reaching": None if reached is None else asdict(reached),
        }
    return records


def study_text(found: dict[str, ConvergenceStudy], tolerance_um: float) -> str:
    """Studies as a table, and below it where each method reaches the tolerance."""
    from gearstudio.analysis.convergence import COUNTED

    rows: list[tuple[str, ...]] = [HEADINGS]
    lines = []
    for info in METHOD_INFOS:
        study = found[info.id]
        rows += [
            (info.title, str(p.count), str(p.poles), f"{p.seconds:.4f}",
             *(f"{um:.3g}" for um in (p.max_um, p.mean_um, p.rms_um)))
            for p in study.points
        ]  # fmt: skip
        reached = study.reaching(tolerance_um)
        effort = "not with these efforts" if reached is None else (
            f"with {reached.count} {COUNTED[info.id]}, {reached.poles} poles, {reached.seconds:.4f} s"
        )  # fmt: skip
        lines.append(f"{info.title} stays within {tolerance_um:g} µm: {effort}")
    return "\n".join([table(rows), "", *lines])
