"""Every equation can be set, its numbers follow the geometry, and every departure of the paper is told."""

import numpy as np
import pytest
import typst
from hypothesis import given, settings

from gearstudio.analysis.datasheet import data_sheet
from gearstudio.catalogue import MEMBERS
from gearstudio.design import Design, all_field_specs, with_field
from gearstudio.equations import (
    EQUATIONS,
    equation,
    equation_for,
    equations_of_field,
    equations_of_quantity,
    fields_of,
    holds,
    listed,
    numbers_of,
)
from gearstudio.presets import PRESETS, Preset
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
        assert _put("mean_module", design, name)["m_n"] == pytest.approx(pair.mean_normal_module, rel=1e-12)
        assert _put("half_thickness", design, name)["j_t"] == pytest.approx(design.tooth.backlash, abs=1e-9)
        own = _put("own_depth", design, name)
        shift = own["x_1"] if name == "pinion" else -own["x_2"]
        assert shift == pytest.approx(design.tooth.profile_shift, abs=1e-12)
        assert own["h_a^*"] == pytest.approx(design.tooth.addendum_factor)
        assert own["c^*"] == pytest.approx(design.tooth.clearance_factor, abs=1e-12)
        assert own["h_(a e)"] == pytest.approx(m.addendum, rel=1e-12)


def test_every_equation_with_numbers_has_them_for_both_members() -> None:
    pair = pair_geometry(Design())
    for one in EQUATIONS:
        for name in MEMBERS:
            found = numbers_of(one, pair, name)
            if found is not None:
                assert found.inputs and found.outputs
                assert all(np.isfinite(g.value) for g in (*found.inputs, *found.outputs))


def _preset(key: str) -> Design:
    return next(preset.design for preset in PRESETS if preset.key == key)


@pytest.mark.parametrize("preset", PRESETS, ids=lambda preset: preset.key)
def test_numbers_are_put_in_where_an_equation_holds_and_nowhere_else(preset: Preset) -> None:
    pair = pair_geometry(preset.design)
    for one in EQUATIONS:
        found = [numbers_of(one, pair, name) for name in MEMBERS]
        if not holds(one, pair):
            assert found == [None, None]
        for put in filter(None, found):
            assert put.inputs and put.outputs
            assert all(np.isfinite(number.value) for number in (*put.inputs, *put.outputs))
    kinds = {one.holds for one in EQUATIONS if one.numbers is not None and holds(one, pair)}
    assert kinds == {"always"} | (
        {"standard depth", "offset"} if pair.has_offset
        else {"no offset", "standard depth"} if pair.hypoid is not None
        else {"no offset", "own depth"}
    )  # fmt: skip


def test_the_equations_of_offset_axes_give_the_data_sheet_of_the_standard() -> None:
    design = _preset("hypoid-car")
    sheet = data_sheet(design)
    for key, quantity, symbol in (
        ("pitch_cones", "delta", "delta_1"),
        ("pitch_cones", "zeta_mp", "zeta_(m p)"),
        ("offset_arms", "a_p", "a_p"),
        ("limit_angle", "alpha_lim", "alpha_lim"),
        ("flank_angles", "alpha_nD", "alpha_(n D)"),
        ("working_depth", "h_mw", "h_(m w)"),
        ("touching_cones", "delta_a", "delta_(a 1)"),
        ("normal_thickness", "s_mn", "s_(m n)"),
        ("diameters", "d_ae", "d_(a e)"),
        ("crown", "t_xo", "t_(x o)"),
        ("apexes", "t_z", "t_z"),
    ):
        assert _put(key, design, "pinion")[symbol] == pytest.approx(sheet.get(quantity, "pinion").value, rel=1e-9), key
    wheel = _put("flank_angles", design, "wheel")
    assert wheel["delta_(b D)"] == pytest.approx(sheet.get("delta_bD", "wheel").value)
    assert _put("base_angle", design, "wheel")["delta_(b D)"] == pytest.approx(wheel["delta_(b D)"])
    assert numbers_of(equation("base_angle"), pair_geometry(design), "pinion") is None
    assert _put("mean_depths", design, "wheel")["h_(a m 2)"] == pytest.approx(sheet.get("h_am", "wheel").value)
    arms = _put("offset_arms", design, "pinion")
    moment = sum(arms[r] * np.sin(np.radians(arms[angle])) for r, angle in (("r_2", "zeta_m"), ("r_1", "eta")))
    assert moment == pytest.approx(design.pair.offset)
    assert _put("limit_radius", design, "wheel")["rho_lim"] == pytest.approx(design.lengthwise.cutter_radius)


@pytest.mark.parametrize("key", ["default", "hypoid-car"])
def test_micro_geometry_is_put_in_flank_by_flank(key: str) -> None:
    design = _preset(key)
    for path, value in (
        ("modifications.pinion.concave.lengthwise_crowning_um", 12.0),
        ("modifications.pinion.convex.tip_relief_um", 7.0),
        ("modifications.wheel.convex.spiral_angle_correction_um", 4.0),
    ):
        design = with_field(design, path, value)
    pinion, wheel = _put("relief", design, "pinion"), _put("relief", design, "wheel")
    assert (pinion["c_(l D)"], pinion["e_D (-1, 0)"], pinion["e_D (1, 0)"]) == pytest.approx((12, 12, 12))
    assert (pinion["c_(l C)"], pinion["e_C (0, 1)"]) == pytest.approx((0, 7))
    assert (wheel["s_D"], wheel["e_D (1, 0)"], wheel["e_D (-1, 0)"]) == pytest.approx((4, -2, 2))
    assert _put("tip_relief", design, "pinion")["e_(t C) (1)"] == pytest.approx(7)


def test_every_field_with_an_equation_leads_to_one_and_back() -> None:
    for path, spec in all_field_specs().items():
        keys = equations_of_field(path)
        assert bool(keys) or not spec.equation, path
        for key in keys:
            assert path in fields_of(equation(key).key)
    assert not equations_of_field("name") and not equations_of_field("blank.pinion.bore_diameter")


@pytest.mark.parametrize("preset", PRESETS, ids=lambda preset: preset.key)
def test_every_field_in_use_and_every_row_of_the_sheet_lead_to_an_equation_that_holds(preset: Preset) -> None:
    pair = pair_geometry(preset.design)
    for quantity in data_sheet(preset.design).quantities:
        keys = equations_of_quantity(quantity.key)
        assert keys and holds(equation(equation_for(keys, pair)), pair), quantity.key
    offset_only = {"pair.offset", "lengthwise.spiral_angle_of", "tooth.limit_pressure_angle_factor"}
    for path, spec in all_field_specs().items():
        in_use = (
            path not in offset_only
            and spec.used_when in (None, ("depth.system", preset.design.depth.system))
            and path not in ("pair.pressure_angle_kind", "lengthwise.spiral_angle_at")
        )
        if in_use and equations_of_field(path):
            assert holds(equation(equation_for(equations_of_field(path), pair)), pair), path


def test_equations_that_concern_no_other_pair_are_left_out() -> None:
    bevel, hypoid = (listed(pair_geometry(_preset(key))) for key in ("default", "hypoid-car"))
    assert {one.key for one in EQUATIONS if one.paper} <= {one.key for one in bevel} & {one.key for one in hypoid}
    assert "offset_arms" not in {one.key for one in bevel} and "offset_arms" in {one.key for one in hypoid}
    assert "own_depth" in {one.key for one in bevel} and "own_depth" not in {one.key for one in hypoid}
