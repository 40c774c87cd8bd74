"""The chapters of the report, each from the content to its blocks; figures are handed to a store."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from gearstudio.analysis.convergence import COUNTED
from gearstudio.catalogue import MEMBERS, METHOD_INFOS, VARIANTS
from gearstudio.design import field_specs
from gearstudio.equations import EQUATIONS, Given, numbers_of
from gearstudio.report import charts, maps
from gearstudio.report.blocks import Block, Chapter, Formula, Heading, Picture, Table, Text, rows
from gearstudio.report.content import Content
from gearstudio.report.sections import SECTIONS
from gearstudio.theory.flank import FLANKS

_PUBLISHED = "The paper states means of 54.6, 60.3 and 52.9 µm for its own gear, whose data it does not print."


@dataclass
class Store:
    """The figures' files as they are made, and the pictures that were handed in."""

    pictures: Mapping[str, bytes]
    files: dict[str, bytes] = field(default_factory=dict)

    def add(self, name: str, content: bytes, caption: str, width: float = 1.0) -> Picture:
        """Keep a file and return the block that shows it."""
        self.files[name] = content
        return Picture(name, caption, width)


def chapter(key: str, content: Content, store: Store) -> Chapter:
    """One chapter of the report."""
    title = next(section.title for section in SECTIONS if section.key == key)
    return Chapter(key, title, tuple(_MAKERS[key](content, store)))


def _design(content: Content, _: Store) -> list[Block]:
    made: list[tuple[str, ...]] = []
    group = ""
    for spec in field_specs():
        if spec.not_yet:
            continue
        value: object = content.design
        for name in spec.path.split("."):
            value = getattr(value, name)
        if spec.group != group:
            group = spec.group
            made.append((group,))
        shown = "derived" if value is None else f"{value:.10g}" if isinstance(value, float) else str(value)
        made.append((spec.title, spec.symbol, shown.replace("_", " "), spec.unit, spec.path))
    return [Table(("Field", "Symbol", "Value", "Unit", "Key in the design file"), rows(made), "llrll")]


def _sheet(content: Content, _: Store) -> list[Block]:
    if content.sheet is None:
        return [Text("This design has no complete tooth; see the notes.")]
    made: list[tuple[str, ...]] = []
    group = ""
    for line in content.sheet.lines():
        first = line[0]
        if first.group != group:
            group = first.group
            made.append((group,))
        values = [line[0].text, line[-1].text]
        where = f"{first.formula} · {first.equation}" if first.formula != "given" else "given"
        made.append((first.name, first.symbol, *values, first.unit, where))
    head = ("Quantity", "Symbol", "Pinion", "Wheel", "Unit", "Formula · section of the theory [equation of the paper]")
    return [Table(head, rows(made), "llrrll")]


def _comparison(content: Content, store: Store) -> list[Block]:
    head = ("Method", "Variant", "Largest", "Mean", "RMS", "Edges", "Poles", "Degree", "Time")
    blocks: list[Block] = [
        Text(
            "Deviation of the CAD surface from the exact flank [µm], normal to it, over both flanks on a grid of "
            f"49 × 49 points that includes the edges. {_PUBLISHED}"
        )
    ]
    for member in MEMBERS:
        made: list[tuple[str, ...]] = [(f"{member.capitalize()}",)]
        for method in METHOD_INFOS:
            for variant in VARIANTS:
                key = (member, method.id, variant)
                if key in content.failures:
                    made.append((method.title, variant, "not built", "", "", "", "", "", ""))
                    blocks.append(Text(f"{member}, {method.title}, {variant}: {content.failures[key]}"))
                elif key in content.results:
                    r = content.results[key]
                    figures = (r.statistics.max_um, r.statistics.mean_um, r.statistics.rms_um)
                    edge = max(one.edge_um for one in r.flanks.values())
                    poles, degree = (f"{a} × {b}" for a, b in (r.poles, r.degree))
                    made.append(
                        (method.title, variant, *(f"{x:.3g}" for x in (*figures, edge)), poles, degree,
                         f"{r.seconds * 1e3:.0f} ms")
                    )  # fmt: skip
        blocks.append(Table(head, rows(made), "llrrrrccr"))
    figure = charts.deviation_series(content)
    caption = f"Deviation of the {content.member} at 7 × 7 points of each flank."
    return [*blocks, store.add("series.svg", figure, caption)]


def _pictures(content: Content, store: Store) -> list[Block]:
    if not store.pictures:
        return [Text("No pictures were taken: there is no drawing without a graphics driver.")]
    return [store.add(f"{name}.png", data, _PICTURES.get(name, name)) for name, data in store.pictures.items()]


_PICTURES = {
    "views": "One flank of the three methods, coloured by its deviation from the exact flank.",
    "pair": "The pair in mesh.",
}


def _deviation(content: Content, store: Store) -> list[Block]:
    caption = "{0} flank of the {1}: signed deviation, plus is metal added; each map has a scale of its own."
    return [
        store.add(f"deviation-{f}.svg", maps.deviation_maps(content, f), caption.format(f.capitalize(), content.member))
        for f in FLANKS
    ]


def _curvature(content: Content, store: Store) -> list[Block]:
    caption = "{0} flank of the {1}: Gaussian curvature of theory and of the optimised surfaces on one scale."
    return [
        store.add(f"curvature-{f}.svg", maps.curvature_maps(content, f), caption.format(f.capitalize(), content.member))
        for f in FLANKS
    ]


def _topography(content: Content, store: Store) -> list[Block]:
    blocks: list[Block] = []
    for method in METHOD_INFOS:
        for variant in VARIANTS:
            if (content.member, method.id, variant) in content.results:
                name = f"topography-{method.id}-{variant}.svg"
                caption = f"{content.member.capitalize()}, {method.title}, {variant}: 5 × 9 points."
                blocks.append(store.add(name, maps.topography(content, method.id, variant), caption))
    return blocks


def _contact(content: Content, store: Store) -> list[Block]:
    found = content.contact
    if found is None:
        return [Text("The contact could not be analysed; see the notes.")]
    made = [
        (
            side.direction, f"{side.peak_to_peak_arcsec:.4g}", f"{side.contact_ratio:.3f}",
            f"{100 * side.pattern_share:.1f}", f"{side.pattern_centre[0]:.2f}", f"{side.pattern_centre[1]:.2f}",
        )
        for side in (found.drive, found.coast)
    ]  # fmt: skip
    head = (
        "Direction",
        "Transmission error p-p [″]",
        "Contact ratio",
        "Pattern [%]",
        "Centre along face",
        "on profile",
    )
    blocks: list[Block] = [
        Text(
            f"Without misalignment, marking compound {found.thickness_um:g} µm thick; the least backlash while rolling "
            f"is {found.play_mm:.4g} mm. Drive: the pinion's concave flank leads."
        ),
        Table(head, rows(made), "lrrrrr"),
        store.add("pattern.svg", charts.patterns(content, found), "Contact pattern on both members."),
        store.add("ease-off.svg", charts.ease_off_maps(content, found), "Ease-off over the pinion's flanks."),
        store.add("transmission.svg", charts.transmission_error(found), "Transmission error over three pitches."),
    ]
    return [*blocks, *(Text(f"Warning: {issue.message}.") for issue in found.warnings)]


def _convergence(content: Content, store: Store) -> list[Block]:
    titles = {method.id: method.title for method in METHOD_INFOS}
    tolerance = content.design.methods.tolerance_um
    made = []
    for study in content.studies:
        reached = study.reaching(tolerance)
        what = COUNTED[study.method]
        found = ("not reached", "", "", "")
        if reached is not None:
            found = (f"{reached.count} {what}", str(reached.poles), f"{reached.seconds * 1e3:.0f} ms",
                     f"{reached.max_um:.3g}")  # fmt: skip
        made.append((titles[study.method], *found))
    head = ("Method", f"Reaches {tolerance:g} µm with", "Poles", "Time", "Largest [µm]")
    caption = f"{content.member.capitalize()}: largest deviation over both flanks against the effort."
    return [
        Text("Every method built with more and more positions, sections or points, and nothing else refined."),
        Table(head, rows(made), "llrrr"),
        store.add("convergence.svg", charts.convergence(content), caption),
    ]


def _equations(content: Content, _: Store) -> list[Block]:
    blocks: list[Block] = []
    group = ""
    for one in EQUATIONS:
        if one.group != group:
            group = one.group
            blocks.append(Heading(group))
        numbers = []
        if one.numbers is not None:
            for member in MEMBERS:
                put = numbers_of(one, content.pair, member)
                assert put is not None
                numbers.append(f'"{member}:" quad ' + ", quad ".join(shown(g) for g in (*put.inputs, *put.outputs)))
        departure = " ".join(part for part in (one.departure, one.evidence) if part)
        number = f"({one.paper})" if one.paper else f"theory {one.section}"
        blocks.append(Formula(one.title, number, one.used, one.printed, one.meaning, departure, tuple(numbers)))
    return blocks


def shown(given: Given) -> str:
    """A symbol with its value and unit, as typst mathematics."""
    value = f"{given.value:.0f}" if not given.unit and given.value == int(given.value) else f"{given.value:.6g}"
    unit = {"": "", "°": '"°"', "mm": ' thin "mm"', "rad": ' thin "rad"'}[given.unit]
    return f"{given.symbol} = {value}{unit}"


_MAKERS: dict[str, Callable[[Content, Store], list[Block]]] = {
    "design": _design,
    "sheet": _sheet,
    "comparison": _comparison,
    "pictures": _pictures,
    "deviation": _deviation,
    "curvature": _curvature,
    "topography": _topography,
    "contact": _contact,
    "convergence": _convergence,
    "equations": _equations,
}
