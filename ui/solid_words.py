"""How the solids in sight stand, in a few words: for the title over the view and the panel beside it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ui.formatting import MEMBER_TITLES, METHOD_TITLES, VARIANT_TITLES, fixed, micrometres, seconds
from ui.units import with_unit
from ui.words import inline, told, tr

if TYPE_CHECKING:
    from ui.measuring import Measure
    from ui.session import Key
    from ui.solids import Solids

UP_TO_DATE = "Up to date"


def state(solids: Solids, keys: Sequence[Key]) -> tuple[str, str, float | None]:
    """Words, colour of the lamp and fraction done (None when nothing is being done) of solids together."""
    at_work = [(key, progress) for key in keys if (progress := solids.progress(key)) is not None]
    if at_work:
        key, progress = next((x for x in at_work if x[1].fraction > 0), at_work[0])
        done = sum(solids.is_current(k) for k in keys) + sum(p.fraction for _, p in at_work)
        return f"{tr(MEMBER_TITLES[key.member])}: {told(progress.stage)}…", "accent", done / len(keys)
    failures = [failure for key in keys if (failure := solids.failure(key)) is not None]
    if failures:
        return told(failures[0].message), "warning" if failures[0].cancelled else "error", None
    if all(solids.is_current(key) for key in keys):
        return tr(UP_TO_DATE), "ok", None
    if any(key in solids.built for key in keys):
        return tr("Out of date: the design has changed"), "warning", None
    return tr("Not built yet"), "muted", None


def titles(solids: Solids, keys: Sequence[Key]) -> tuple[str, str]:
    """Title and subtitle over the view."""
    name = tr(MEMBER_TITLES[keys[0].member]) if len(keys) == 1 else tr("Pair")
    title = f"{name} · {inline(METHOD_TITLES[keys[0].method])} · {inline(VARIANT_TITLES[keys[0].variant])}"
    text, _, _ = state(solids, keys)
    if text != tr(UP_TO_DATE):
        return title, text
    built = [solids.built[key] for key in keys]
    faces = sum(b.result.face_count for b in built)
    took = seconds(sum(b.result.seconds for b in built))
    return title, tr(
        "{faces} faces · flanks within {largest} · built in {took}",
        faces=faces,
        largest=micrometres(max(b.largest_um for b in built)),
        took=took,
    )


def spot_words(member: str, face: str, tooth: int | None, azimuth_deg: float) -> str:
    """Where a point of a solid is."""
    name = tr(MEMBER_TITLES[member])
    words = f"{name}, {tr(face)}" if face else name
    if tooth is not None:
        words = tr("{member}, {face}, tooth {number}", member=name, face=tr(face), number=tooth)
    return f"{words}    φ {fixed(azimuth_deg, 3)}°"


def measured(found: Measure) -> str:
    """A measurement as rich text for the panel."""
    rows = [(tr("Distance"), f"<b>{with_unit(found.distance, 'mm', 4)}</b>")]
    rows += [(f"Δ{name}", with_unit(value, "mm", 4)) for name, value in zip("xyz", found.across, strict=True)]
    for title, value, unit in (
        (tr("Radial"), found.radial, "mm"),
        (tr("Axial"), found.axial, "mm"),
        (tr("Azimuth"), found.azimuth, "°"),
        (tr("Between normals"), found.normals, "°"),
    ):
        if value is not None:
            rows.append((title, with_unit(value, unit, 4)))
    cells = "".join(f"<tr><td>{title}&nbsp;&nbsp;</td><td align='right'>{text}</td></tr>" for title, text in rows)
    return f"<table>{cells}</table>"
