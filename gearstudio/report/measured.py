"""The chapter about measured points: how they lie to the theory, as numbers, on the flanks and from tooth to tooth."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.measurement import MeasurementResult
from gearstudio.analysis.measurement_errors import NAMED_ERRORS, NamedError
from gearstudio.report import measured_charts
from gearstudio.report.blocks import Block, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.language import FLANKS_SAID, inline, number, told, tr
from gearstudio.report.language import MEMBERS_SAID as MEMBERS
from gearstudio.report.measuring import Measured
from gearstudio.report.store import Store
from gearstudio.theory.flank import FLANKS, FlankName

Read = Callable[[FlankName], float | None]
_NOTHING = "–"


def chapter_blocks(content: Content, store: Store) -> list[Block]:
    """What was measured and how, whether it is this gear, the errors of each flank, the map and the pitch."""
    found = content.measured
    if found is None:
        return [Text(tr("The measured points could not be compared with this design; see the notes."))]
    result = found.result
    member = content.pair.member(result.member)
    blocks: list[Block] = [
        Text(_how(found)),
        *(Text(tr("Warning: {message}.", message=told(doubt.message))) for doubt in result.warnings),
        Table((tr("All points"), tr("Value"), tr("Unit")), rows(_whole(result, member.teeth)), "lrl"),
        Table((tr("Error"), *(tr(FLANKS_SAID[name]) for name in FLANKS), tr("Unit")), rows(_flanks(result)), "lddl"),
        store.add(
            "measured.svg", measured_charts.topography(member, result),
            tr("{member}: measured deviation, mean of all teeth; a bar upwards and red is metal added.",
               member=tr(MEMBERS[result.member])),
        ),
    ]  # fmt: skip
    if any(len(pitch.tooth) > 1 for pitch in result.pitch.values()):
        caption = tr("{member}: pitch errors of the teeth that were measured.", member=tr(MEMBERS[result.member]))
        blocks.append(store.add("pitch.svg", measured_charts.pitch(result), caption))
    return blocks


def _how(found: Measured) -> str:
    file, member = found.file, inline(MEMBERS[found.result.member])
    free = [word for word, may in zip((tr("turn"), tr("shift")), file.fit, strict=True) if may]
    fit = tr("The best fit might {ways}.", ways=tr(" and ").join(free)) if free else tr("There was no best fit.")
    if file.faces is None:
        source = tr("{file}, against the {member}.", file=file.name, member=member)
    else:
        source = tr(
            "{file}, against the {member}: points of {flanks} flank faces of {faces}.",
            file=file.name, member=member, flanks=file.faces[0], faces=file.faces[1],
        )  # fmt: skip
    meaning = tr(
        "Deviations are normal to the flank, plus is metal added. Errors are those of all teeth of a flank together: "
        "of the spiral angle from toe to heel, of the pressure angle from root to tip, crowning as the height of the "
        "middle above the ends, the pitch as an arc of the mean pitch circle."
    )
    return f"{source} {fit} {meaning}"


def _whole(result: MeasurementResult, teeth: int) -> list[tuple[str, ...]]:
    count = f"{len(np.unique(result.tooth))} / {teeth}"
    return [
        (tr("Points on the flanks"), str(len(result.points)), ""),
        (tr("Points left out beside the flanks"), str(result.beside), ""),
        (tr("Teeth measured"), count, ""),
        (tr("Turned by the best fit"), number(float(np.degrees(result.pose.turn)), ".6f"), "°"),
        (tr("Shifted by the best fit"), number(result.pose.shift * 1e3, ".3f"), "µm"),
        (tr("Largest deviation without its sign"), number(result.statistics.max_um, ".3f"), "µm"),
        (tr("Mean deviation without its sign"), number(result.statistics.mean_um, ".3f"), "µm"),
        (tr("RMS deviation"), number(result.statistics.rms_um, ".3f"), "µm"),
    ]


def _flanks(result: MeasurementResult) -> list[tuple[str, ...]]:
    names, form, pitch = np.asarray(result.flanks), result.form, result.pitch

    def of(name: FlankName) -> NDArray[np.float64]:
        return np.asarray(result.deviation_um[names == name])

    def row(title: str, read: Read, unit: str = "µm") -> tuple[str, ...]:
        spec = ".5f" if unit == "°" else ".2f"
        values = (read(name) if name in form else None for name in FLANKS)
        return (title, *(_NOTHING if value is None else number(value, spec) for value in values), unit)

    def named(error: NamedError) -> tuple[str, ...]:
        return row(tr(error.title), lambda name: error.of(form[name], pitch[name]), error.unit)

    return [
        (tr("Points"), *(str(np.count_nonzero(names == name)) for name in FLANKS), ""),
        row(tr("RMS deviation"), lambda name: float(np.sqrt(np.mean(of(name) ** 2)))),
        row(tr("Highest deviation"), lambda name: float(of(name).max())),
        row(tr("Lowest deviation"), lambda name: float(of(name).min())),
        *map(named, NAMED_ERRORS),
    ]
