"""What a gear may be made of, and what it weighs then."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ui.formatting import seconds, significant
from ui.units import MM_PER_INCH, display, to_shown, unit_shown
from ui.words import tr

if TYPE_CHECKING:
    from collections.abc import Sequence

    from gearstudio.results import SolidResult

CUSTOM = "Custom"
KG_PER_MM3 = 1e-9
"""Of a density of 1 kg/m³."""


@dataclass(frozen=True)
class Material:
    """A material and its density [kg/m³]."""

    name: str
    density: float


MATERIALS = (
    Material("Steel", 7850.0),
    Material("Cast iron", 7200.0),
    Material("Bronze", 8800.0),
    Material("Brass", 8500.0),
    Material("Aluminium", 2700.0),
    Material("POM", 1410.0),
)


POUNDS = 1 / 0.45359237
"""Of a kilogram."""
Units = tuple[tuple[str, float], ...]
IN_MILLIMETRES: tuple[Units, Units, Units, Units] = (
    (("mm³", 1.0), ("cm³", 1e-3), ("dm³", 1e-6)),
    (("mm²", 1.0), ("cm²", 1e-2)),
    (("g", 1e3), ("kg", 1.0)),
    (("g mm²", 1e3), ("kg mm²", 1.0), ("kg m²", 1e-6)),
)
"""Units of volume, area, mass and moment of inertia, with their parts of a mm³, mm², kg and kg mm²."""
IN_INCHES: tuple[Units, Units, Units, Units] = (
    (("in³", MM_PER_INCH**-3),),
    (("in²", MM_PER_INCH**-2),),
    (("oz", 16 * POUNDS), ("lb", POUNDS)),
    (("oz in²", 16 * POUNDS * MM_PER_INCH**-2), ("lb in²", POUNDS * MM_PER_INCH**-2)),
)


def density_unit() -> tuple[str, float]:
    """Unit in which a density is shown and typed, and its part of a kg/m³."""
    in_inches = display().length == "in"
    return ("lb/in³", KG_PER_MM3 * POUNDS * MM_PER_INCH**3) if in_inches else ("kg/m³", 1.0)


@dataclass(frozen=True)
class Property:
    """A row of the table of properties: title, unit, a text for each solid, what it means."""

    title: str
    unit: str
    texts: tuple[str, ...]
    tip: str


def properties(results: Sequence[SolidResult | None], density: float) -> tuple[Property, ...]:
    """What there is to say of solids of a density [kg/m³]; one column for each, empty where there is none."""
    weight = density * KG_PER_MM3

    def row(title: str, unit: str, tip: str, read: object) -> Property:
        return Property(title, unit, tuple("–" if r is None else read(r) for r in results), tip)  # type: ignore[operator]

    def scaled(title: str, tip: str, units: Units, read: object) -> Property:
        values = [0.0 if r is None else abs(read(r)) for r in results]  # type: ignore[operator]
        unit, factor = _unit(max(values, default=0.0), units)
        return row(title, unit, tip, lambda r: significant(factor * read(r), 4))  # type: ignore[operator]

    volumes, areas, masses, inertias = IN_INCHES if display().length == "in" else IN_MILLIMETRES
    return (
        row(tr("Valid"), "", tr("The kernel's full check of the solid"), lambda r: tr("yes") if r.valid else tr("no")),
        row(tr("Closed"), "", tr("One closed shell"), lambda r: tr("yes") if r.closed else tr("no")),
        row(tr("Faces"), "", tr("Number of faces of the solid"), lambda r: str(r.face_count)),
        scaled(tr("Gap"), tr("Largest between neighbouring faces"), (("nm", 1e6), ("µm", 1e3)), lambda r: r.gap),
        scaled(tr("Volume"), tr("Enclosed"), volumes, lambda r: r.properties.volume),
        scaled(tr("Area"), tr("Of the whole surface"), areas, lambda r: r.properties.area),
        scaled(tr("Mass"), tr("In the chosen material"), masses, lambda r: weight * r.properties.volume),
        row(tr("Centre z"), unit_shown("mm"), tr("Of mass, from the apex"), lambda r: _centre(r.properties.centre[2])),
        scaled(
            tr("Inertia z"), tr("About the gear's axis"), inertias, lambda r: weight * float(r.properties.inertia[2, 2])
        ),
        scaled(
            tr("Inertia x"),
            tr("About an axis through the centre of mass, square to the gear's axis"),
            inertias,
            lambda r: weight * float(r.properties.inertia[0, 0]),
        ),
        row(tr("Built in"), "", tr("Building and checking"), lambda r: seconds(r.seconds)),
    )


def _centre(z: float) -> str:
    return significant(to_shown(z, "mm"), 5)


def _unit(value: float, units: Units) -> tuple[str, float]:
    """The largest unit in which a value is not below one."""
    fitting = [unit for unit in units if value * unit[1] >= 1]
    return fitting[-1] if fitting else units[0]
