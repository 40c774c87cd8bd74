"""Every equation can be set, its numbers follow the geometry, and every departure of the paper is told."""

import numpy as np
import pytest
import typst
from hypothesis import given, settings

from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design
from gearstudio.equations import EQUATIONS, equation, numbers_of
from gearstudio.presets import PRESETS
from gearstudio.theory.cones import pair_geometry
from tests.strategies import designs

DEPARTURES = {"1", "4", "5", "9", "11", "13, 16", "20", "21", "22, 23", "24"}


def _put(key: str, design: Design, member: str) -> dict[str, float]:
    found = numbers_of(equation(key), pair_geometry(design), member)
    assert found is not None
    return {one.symbol: one.value for one in (*found.inputs, *found.outputs)}


def test_every_departure_is_told_with_its_evidence() -> None:
    departing = {one.paper for one in EQUATIONS if one.printed}
    assert departing == DEPARTURES
    for one in EQUATIONS:
        assert bool(one.printed) == bool(one.departure) == bool(one.evidence)


def test_all_numbers_of_the_paper_are_there() -> None:
    told = {int(n) for one in EQUATIONS for n in one.paper.replace(" ", "").split(",") if n}
    assert told == set(range(1, 25))
    assert len({one.key for one in EQUATIONS}) == len(EQUATIONS)


def test_every_formula_can_be_set() -> None:
    lines = [f"$ {text} $" for one in EQUATIONS for text in (one.used, one.printed) if text]
    assert typst.compile("\n\n".join(lines).encode(), format="pdf").startswith(b"%PDF")


@settings(max_examples=30)
@given(design=designs())
def test_the_numbers_agree_with_the_geometry(design: Design) -> None:
    pair = pair_geometry(design)
    for name in MEMBERS:
        m = pair.member(name)
        assert _put("pitch_angle", design, name)["delta"] == pytest.approx(np.degrees(m.pitch_angle), rel=1e-12)
        assert _put("base_angle", design, name)["delta_b"] == pytest.approx(np.degrees(m.base_angle), rel=1e-12)
        assert _put("base_radius", design, name)["R_b"] == pytest.approx(m.base_radius, rel=1e-12)
        assert _put("cone_distance", design, name)["R"] == pytest.approx(m.outer_cone_distance, rel=1e-12)
        assert _put("transverse_angle", design, name)["alpha"] == pytest.approx(np.degrees(m.transverse_pressure_angle))
        assert _put("trace", design, name)["beta_m"] == pytest.approx(np.degrees(pair.mean_spiral_angle))


def test_every_equation_with_numbers_has_them_for_both_members() -> None:
    pair = pair_geometry(Design())
    for one in EQUATIONS:
        for name in MEMBERS:
            found = numbers_of(one, pair, name)
            if found is not None:
                assert found.inputs and found.outputs
                assert all(np.isfinite(g.value) for g in (*found.inputs, *found.outputs))


def test_no_numbers_are_put_in_where_the_equations_do_not_hold() -> None:
    pair = pair_geometry(next(preset.design for preset in PRESETS if preset.key == "hypoid-car"))
    assert all(numbers_of(one, pair, name) is None for one in EQUATIONS for name in MEMBERS)
