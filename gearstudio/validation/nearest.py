"""The nearest value of a field with which a design works: what a message offers as remedy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil, floor, log10

from gearstudio.design import Design, all_field_specs, field_value, with_field
from gearstudio.errors import GeometryError
from gearstudio.theory.hypoid.depth import addendum_factor_of_shift
from gearstudio.validation.patience import is_late
from gearstudio.validation.rule import acting, explicit

Works = Callable[[Design], bool]
_SCAN = 25
_HALVINGS = 20
_DIGITS = 4
_CLOSE = 1e-5


@dataclass(frozen=True)
class Cure:
    """Changes of one field each that make a design work, in words, and the field of the first; both may be empty."""

    text: str
    field: str


def cure(design: Design, works: Works, candidates: Sequence[tuple[str, float]], scan: int = _SCAN) -> Cure:
    """What to change to make a design work.

    Parameters
    ----------
    design : Design
    works : callable
        Whether a changed design is free of the problem at hand.
    candidates : sequence of (path, toward)
        Fields to try, each from its present value toward another one.
    scan : int
        Into how many steps that way is divided: few where an answer takes long.
    """
    offers: dict[str, str] = {}
    design = explicit(design)
    for path, toward in (_acting(design, *candidate) for candidate in candidates):
        value = None if path in offers or is_late() else nearest(design, path, works, toward, scan)
        if value is not None:
            offers[path] = offer(design, path, value)
    return Cure(" or ".join(offers.values()), next(iter(offers), ""))


def _acting(design: Design, path: str, toward: float) -> tuple[str, float]:
    """The field that acts in the design's depth system, and the value towards which to try it."""
    found = acting(design, path)
    if found == path:
        return path, toward
    depth = design.depth.depth_factor
    shares = {"tooth.profile_shift": addendum_factor_of_shift(toward, depth), "tooth.clearance_factor": toward / 2}
    spec = all_field_specs()[found]
    return found, min(max(shares.get(path, 2 * toward), spec.minimum or 0.0), spec.maximum or 1.0)


def offer(design: Design, path: str, value: float) -> str:
    """A value in words, ``"a cutter radius of at least 21.3 mm"``."""
    spec = all_field_specs()[path]
    name = spec.title.lower()
    article = "an" if name[0] in "aeiou" else "a"
    unit = "" if not spec.unit else spec.unit if spec.unit == "°" else f" {spec.unit}"
    word = "most" if value < field_value(design, path) else "least"
    return f"{article} {name} of at {word} {value:.10g}{unit}"


def nearest(design: Design, path: str, works: Works, toward: float, scan: int = _SCAN) -> float | None:
    """The value nearest to the present one, on the way to another, with which a design works.

    Rounded to four digits on the working side; None when none was found. Whole fields get whole values.
    """
    start = float(field_value(design, path))
    whole = all_field_specs()[path].kind == "int"

    def works_at(value: float) -> bool:
        try:
            return works(with_field(design, path, round(value) if whole else value))
        except (GeometryError, ValueError):
            return False

    if start == toward:
        return None
    if whole:
        step = 1 if toward > start else -1
        return next((float(n) for n in range(int(start) + step, int(toward) + step, step) if works_at(n)), None)
    places = [start + (toward - start) * k / (scan - 1) for k in range(scan)]
    first = next((k for k in range(1, scan) if not is_late() and works_at(places[k])), None)
    if first is None:
        return None
    bad, good = places[first - 1], places[first]
    for _ in range(_HALVINGS):
        if is_late() or abs(good - bad) < _CLOSE * abs(good):
            break
        middle = (bad + good) / 2
        bad, good = (bad, middle) if works_at(middle) else (middle, good)
    rounded = round_toward(good, up=toward > start)
    return rounded if works_at(rounded) else good


def round_toward(value: float, *, up: bool) -> float:
    """A value with four digits, rounded up or down."""
    if value == 0:
        return 0.0
    scale = 10.0 ** (_DIGITS - 1 - floor(log10(abs(value))))
    return (ceil(value * scale) if up else floor(value * scale)) / scale
