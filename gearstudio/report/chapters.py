"""The chapters of the report, each from the content to its blocks; figures are handed to a store."""

from __future__ import annotations

from collections.abc import Callable

from gearstudio.catalogue import MEMBERS
from gearstudio.equations import Equation, listed, numbers_of
from gearstudio.report import contact_charts, exports, measured, method_chapters
from gearstudio.report.blocks import Block, Chapter, Formula, Heading, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.design_tables import design_blocks, sheet_blocks
from gearstudio.report.language import DIRECTIONS_SAID, MEMBERS_SAID, notation, number, told, tr
from gearstudio.report.mathematics import pointed, prose
from gearstudio.report.sections import SECTIONS
from gearstudio.report.store import Store

_TINY_MM = 1e-9


def chapter(key: str, content: Content, store: Store) -> Chapter:
    """One chapter of the report."""
    title = next(section.title for section in SECTIONS if section.key == key)
    return Chapter(key, tr(title), tuple(_MAKERS[key](content, store)))


def _pictures(_: Content, store: Store) -> list[Block]:
    caption = tr("One flank of the three methods, coloured by its deviation from the exact flank.")
    views = store.picture("views", caption)
    problems: list[Block] = [
        Text(tr("A picture is missing: {reason}", reason=told(problem))) for problem in store.taken.problems
    ]
    if views is None and not problems:
        problems = [Text(tr("No pictures were handed in."))]
    return problems if views is None else [views, *problems]


def _contact(content: Content, store: Store) -> list[Block]:
    found = content.contact
    if found is None:
        return [Text(tr("The contact could not be analysed; see the notes."))]
    made = [
        (
            tr(DIRECTIONS_SAID[side.direction]), contact_charts.arcsec(side.peak_to_peak_arcsec),
            number(side.contact_ratio, ".3f"), number(100 * side.pattern_share, ".1f"),
            number(side.pattern_centre[0], ".2f"), number(side.pattern_centre[1], ".2f"),
        )
        for side in (found.drive, found.coast)
    ]  # fmt: skip
    head = (
        tr("Direction"), tr("Transmission error, peak to peak [″]"), tr("Contact ratio"), tr("Pattern [%]"),
        tr("Centre along face"), tr("Centre on profile"),
    )  # fmt: skip
    play = 0.0 if abs(found.play_mm) < _TINY_MM else found.play_mm
    intro = tr(
        "Without misalignment, marking compound {thickness} µm thick; the least backlash while rolling is {play} mm. "
        "Drive: the pinion's concave flank leads. The centre of the pattern is given as a part of the face from the "
        "toe and of the profile from the root.",
        thickness=number(found.thickness_um, "g"), play=number(play, ".4g"),
    )  # fmt: skip
    return [
        Text(intro),
        Table(head, rows(made), "lddddd", (1.0, 1.3, 1.0, 1.0, 1.0, 1.0)),
        *(Text(tr("Warning: {message}.", message=told(issue.message.rstrip(".")))) for issue in found.warnings),
        store.add("pattern.svg", contact_charts.patterns(content, found), tr("Contact pattern on both members.")),
        store.add(
            "ease-off.svg", contact_charts.ease_off_maps(content, found),
            tr("Ease-off over the pinion's flanks; white throughout where the flanks are exactly conjugate."),
        ),
        store.add(
            "transmission.svg", contact_charts.transmission_error(found), tr("Transmission error over three pitches."),
        ),
    ]  # fmt: skip


def _equations(content: Content, _: Store) -> list[Block]:
    blocks: list[Block] = [
        Text(
            tr(
                "As they are computed, in the order of the theory; beside a bar what the paper prints where that "
                "differs."
            )
        )
    ]
    if content.pair.hypoid is not None:
        blocks.append(
            Text(
                tr(
                    "Some of the paper's are those of bevel pairs with depths from the module: numbers are put in "
                    "where an equation holds for this pair."
                )
            )
        )
    group = ""
    for one in listed(content.pair):
        if one.group != group:
            group = one.group
            blocks.append(Heading(tr(group)))
        blocks.append(_formula(one, content))
    return blocks


def _formula(one: Equation, content: Content) -> Formula:
    numbers = []
    for member in MEMBERS:
        put = numbers_of(one, content.pair, member)
        if put is not None:
            line = tuple(pointed(given.mathematics(6)) for given in (*put.inputs, *put.outputs))
            numbers.append((tr(MEMBERS_SAID[member]), line))
    departure = " ".join(tr(part) for part in (one.departure, one.evidence) if part)
    return Formula(
        tr(one.title), _where(one), pointed(one.used), pointed(one.printed), prose(notation(tr(one.meaning))),
        prose(notation(departure)), tuple(numbers),
    )  # fmt: skip


def _where(one: Equation) -> str:
    if one.paper:
        return f"({one.paper})"
    numbered = one.section[:1].isdigit()
    return tr("theory, section {number}", number=one.section) if numbered else tr(one.section)


def _exports(content: Content, _: Store) -> list[Block]:
    return exports.chapter_blocks(content.exports, content.folder)


_MAKERS: dict[str, Callable[[Content, Store], list[Block]]] = {
    "design": lambda content, _: design_blocks(content),
    "sheet": lambda content, _: sheet_blocks(content),
    "comparison": method_chapters.comparison,
    "pictures": _pictures,
    "deviation": method_chapters.deviation,
    "curvature": method_chapters.curvature,
    "topography": method_chapters.topography,
    "measurement": measured.chapter_blocks,
    "contact": _contact,
    "convergence": method_chapters.convergence,
    "exports": _exports,
    "equations": _equations,
}
