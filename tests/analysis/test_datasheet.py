"""The data sheet against drawings of the theory itself, and the published values to their last digit."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

from gearstudio.analysis.datasheet import DataSheet, Owner, data_sheet, sheet_text
from gearstudio.analysis.selfcheck import Check, self_check
from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design
from gearstudio.theory.cones import pair_geometry
from gearstudio.theory.involute_flank import InvoluteFlank
from tests.designs import GOLDEN

DESIGNS = {name: design for name, (design, _) in GOLDEN.items()} | {
    "default": Design(),
    "constant clearance": Design.model_validate(
        {"tooth": {"tip_cone": "constant_clearance", "profile_shift": 0.2, "backlash": 0.1}}
    ),
}
CHECKS = self_check()


def value(sheet: DataSheet, key: str, owner: Owner = "pair") -> float:
    return sheet.get(key, owner).value


@pytest.mark.parametrize("check", CHECKS, ids=lambda c: f"{c.source[:3]} {c.name}")
def test_published_values_to_the_last_digit(check: Check) -> None:
    if check.value is None:
        assert check.passed is None and "not printed" in check.source
    else:
        assert check.passed
        assert check.computed == check.published


def test_every_published_number_is_checked() -> None:
    """Counted by hand: 11 rows of two, 7 single values and 4 rows of two, 3 rows of two, 5 of the paper."""
    assert len(CHECKS) == 22 + 7 + 8 + 6 + 5


def test_a_wrong_digit_fails() -> None:
    assert Check("a", "b", "mm", "1.234", 1.2346).passed is False
    assert Check("a", "b", "mm", "1.234", 1.2344).passed is True


@pytest.mark.parametrize("name", DESIGNS)
def test_diameters_and_heights_are_those_of_points(name: str) -> None:
    """The corners of the blank, found on the back and front cones by bisection of their own definition."""
    design = DESIGNS[name]
    pair, sheet = pair_geometry(design), data_sheet(design)
    for owner in MEMBERS:
        m = pair.member(owner)
        for place, rho_u in (("e", m.outer_cone_distance), ("m", m.mean_cone_distance), ("i", m.inner_cone_distance)):
            for letter, limit in (("a", m.tip_limit), ("f", m.root_limit)):
                delta = float(limit.at_back_cone(rho_u))
                rho = rho_u / np.cos(delta - m.pitch_angle)
                assert value(sheet, f"d_{letter}{place}", owner) == pytest.approx(2 * rho * np.sin(delta), rel=1e-12)
        tip = float(m.tip_limit.at_back_cone(m.outer_cone_distance))
        crown = m.outer_cone_distance / np.cos(tip - m.pitch_angle) * np.cos(tip)
        assert value(sheet, "t_xo", owner) == pytest.approx(crown, rel=1e-12)
        assert value(sheet, "b_x", owner) == pytest.approx(
            value(sheet, "t_xo", owner) - value(sheet, "t_xi", owner), rel=1e-12
        )


@pytest.mark.parametrize("name", DESIGNS)
def test_thickness_is_that_of_the_flanks(name: str) -> None:
    design = DESIGNS[name]
    pair, sheet = pair_geometry(design), data_sheet(design)
    for owner in MEMBERS:
        m = pair.member(owner)
        left, right = (InvoluteFlank(m, side).points_at(m.outer_cone_distance, m.pitch_angle) for side in (1, -1))
        assert value(sheet, "s_etc", owner) == pytest.approx(np.linalg.norm(left - right), rel=1e-12)
        assert value(sheet, "s_et", owner) > value(sheet, "s_etc", owner)
        tip = float(m.tip_limit.at_sphere(m.inner_cone_distance))
        corners = [InvoluteFlank(m, side).azimuth(m.inner_cone_distance, tip) for side in (1, -1)]
        land = (corners[0] - corners[1]) * m.inner_cone_distance * np.sin(tip)
        assert value(sheet, "s_ai", owner) == pytest.approx(land, rel=1e-10)


@pytest.mark.parametrize("name", DESIGNS)
def test_thicknesses_and_backlash_fill_the_pitch(name: str) -> None:
    sheet = data_sheet(DESIGNS[name])
    together = sum(value(sheet, "s_et", owner) for owner in MEMBERS) + value(sheet, "j_t")
    assert together == pytest.approx(np.pi * value(sheet, "m"), rel=1e-12)


def test_constant_clearance_is_constant() -> None:
    sheet = data_sheet(DESIGNS["constant clearance"])
    for owner in MEMBERS:
        assert [value(sheet, f"c_{place}", owner) for place in "emi"] == pytest.approx([1.0] * 3, rel=3e-3)


def test_margins_say_undercut_and_pointed_tips() -> None:
    few = Design.model_validate({"pair": {"pinion_teeth": 7, "pressure_angle_deg": 14.5}})
    assert value(data_sheet(few), "undercut", "pinion") < 0 < value(data_sheet(Design()), "undercut", "pinion")


def test_every_input_is_another_quantity_with_its_value() -> None:
    sheet = data_sheet(DESIGNS["constant clearance"])
    known = {(q.symbol, round(q.value, 9)) for q in sheet.quantities}
    for quantity in sheet.quantities:
        assert quantity.formula and quantity.equation
        assert quantity.formula.startswith("given") or quantity.inputs or "given" in quantity.formula
        for symbol, number, _ in quantity.inputs:
            assert any(symbol.startswith(name) and round(number, 9) == shown for name, shown in known), quantity.key


def test_a_value_explains_itself() -> None:
    quantity = data_sheet(Design()).get("delta", "pinion")
    assert quantity.explanation == (
        "tan δ = sin Σ / (z_mate/z + cos Σ) with Σ = 90.00000°, z = 17, z of the mate = 40: δ = 23.02549° (theory 2)"
    )


def test_text_csv_and_latex() -> None:
    sheet = data_sheet(Design())
    text = sheet_text(sheet, "text")
    assert "Outer cone distance" in text and "86.9253 mm" in text
    rows = list(csv.DictReader(io.StringIO(sheet_text(sheet, "csv"))))
    assert len(rows) == len(sheet.quantities)
    for row, quantity in zip(rows, sheet.quantities, strict=True):
        assert float(row["value"]) == quantity.value and row["member"] == quantity.owner
    latex = sheet_text(sheet, "latex")
    assert latex.count(r"\begin{tabular}") == latex.count(r"\end{tabular}") == 1
    assert latex.isascii()
    assert all(line.count("&") == 4 for line in latex.splitlines() if "&" in line and "multicolumn{2}" not in line)


def test_keys_are_unique_per_member() -> None:
    keys = [(q.key, q.owner) for q in data_sheet(Design()).quantities]
    assert len(keys) == len(set(keys))
