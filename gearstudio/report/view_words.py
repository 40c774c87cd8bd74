"""What stands over the pictures of the views, in the language of the report."""

from __future__ import annotations

from gearstudio.catalogue import METHOD_INFOS
from gearstudio.report.language import VARIANTS_SAID, inline, number, tr
from gearstudio.report.style import length_unit
from gearstudio.results import VariantResult

_TITLES = {info.id: info.title for info in METHOD_INFOS}


def view_title(method: str, variant: str) -> str:
    """Method and variant."""
    return f"{tr(_TITLES[method])} · {inline(VARIANTS_SAID[variant])}"


def deviation_words(result: VariantResult) -> str:
    """The deviation of a result in a few words."""
    found = result.statistics
    return tr("max {largest} · mean {mean}", largest=_length(found.max_um), mean=_length(found.mean_um))


def _length(value_um: float) -> str:
    unit, factor = length_unit(value_um)
    return f"{number(value_um * factor, '.3g')} {unit}"
