"""STEP files as text, read without the kernel that wrote them: header, units, products, names, colours, topology."""

from __future__ import annotations

from collections import Counter
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import BSpline

from gearstudio.design import Design, with_field
from gearstudio.exchange.solids import Product
from gearstudio.formats import ExportOptions
from tests.exchange.part21 import Entity, Enum, Ref, StepText, parse, refs

pytestmark = pytest.mark.kernel

SMALL = with_field(with_field(Design(), "pair.pinion_teeth", 9), "pair.wheel_teeth", 14)
CHAMFERED = with_field(SMALL, "blank.pinion.end_chamfer", 1.0)
CASES = {
    "gear": ("pinion", "gear", {}, 1),
    "chamfered": ("pinion", "gear", {}, 1),
    "tooth in ap214": ("wheel", "tooth", {"step_schema": "ap214"}, 1),
    "inches in ap203": ("pinion", "tooth", {"step_schema": "ap203", "step_unit": "inch"}, 1),
    "pair": ("pair", "gear", {}, 2),
}
SCHEMAS = {
    "ap242": "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING",
    "ap214": "AUTOMOTIVE_DESIGN",
    "ap203": "CONFIG_CONTROL_DESIGN",
}


@pytest.fixture(scope="module", params=CASES)
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, StepText]:
    member, part, options, _ = CASES[request.param]
    path = tmp_path_factory.mktemp("step") / "Zahn 歯.step"
    design = CHAMFERED if request.param == "chamfered" else SMALL
    Product(design, member, part, "profile_sweep", "optimised", options=ExportOptions(**options)).write(path, "step")
    return request.param, parse(path.read_bytes().decode("ascii"))


def test_header_says_what_it_is(case: tuple[str, StepText]) -> None:
    name, step = case
    assert list(step.header) == ["FILE_DESCRIPTION", "FILE_NAME", "FILE_SCHEMA"]
    description, level = step.header["FILE_DESCRIPTION"]
    assert description and level in ("1", "2;1")
    assert len(step.header["FILE_NAME"]) == 7
    (schemas,) = step.header["FILE_SCHEMA"]
    assert schemas and schemas[0].startswith(SCHEMAS[CASES[name][2].get("step_schema", "ap242")])


def test_every_instance_that_is_named_exists(case: tuple[str, StepText]) -> None:
    _, step = case
    named = {number for entity in step.data.values() for number in refs(list(entity.parts.values()))}
    assert named <= step.data.keys()


def test_every_representation_has_units_and_an_uncertainty(case: tuple[str, StepText]) -> None:
    name, step = case
    contexts = step.all("GLOBAL_UNIT_ASSIGNED_CONTEXT")
    assert contexts
    for _, context in contexts:
        units = [step.get(ref) for ref in context.parts["GLOBAL_UNIT_ASSIGNED_CONTEXT"][0]]
        length = next(unit for unit in units if "LENGTH_UNIT" in unit.parts)
        if CASES[name][2].get("step_unit") == "inch":
            unit_name, measure = length.parts["CONVERSION_BASED_UNIT"]
            (typed, (factor,)), base = step.get(measure).values
            assert (unit_name, typed) == ("INCH", "LENGTH_MEASURE") and factor == pytest.approx(25.4)
            assert step.get(base).parts["SI_UNIT"] == [Enum("MILLI"), Enum("METRE")]
        else:
            assert length.parts["SI_UNIT"] == [Enum("MILLI"), Enum("METRE")]
        assert [None, Enum("RADIAN")] in [u.parts["SI_UNIT"] for u in units if "PLANE_ANGLE_UNIT" in u.parts]
        assert context.parts["GEOMETRIC_REPRESENTATION_CONTEXT"] == [3]
        (uncertainty,) = context.parts["GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT"][0]
        assert 0 < step.get(uncertainty).values[0][1][0] < 1e-3


def test_products_have_names_and_shapes(case: tuple[str, StepText]) -> None:
    name, step = case
    member, part, _, solids = CASES[name]
    names = [entity.values[1] for _, entity in step.all("PRODUCT")]
    wanted = ["pair-gear", "pinion", "wheel"] if member == "pair" else [names[0]]
    assert sorted(names) == wanted and all(names)
    assert len(step.all("SHAPE_DEFINITION_REPRESENTATION")) >= len(names)
    assert len(step.all("NEXT_ASSEMBLY_USAGE_OCCURRENCE")) == (2 if solids == 2 else 0)
    assert len(step.all("MANIFOLD_SOLID_BREP")) == solids
    faces = {entity.values[0] for _, entity in step.all("ADVANCED_FACE")}
    assert {"tooth 1 concave", "tooth 7 convex fillet"} <= faces or (part == "tooth" and {"concave", "tip"} <= faces)


def test_colours_are_colours_and_of_faces_or_solids(case: tuple[str, StepText]) -> None:
    _, step = case
    styled = step.all("STYLED_ITEM") + step.all("OVER_RIDING_STYLED_ITEM")
    kinds = {step.get(entity.values[2]).kind for _, entity in styled}
    assert kinds <= {"ADVANCED_FACE", "MANIFOLD_SOLID_BREP", "SHAPE_REPRESENTATION"} and "ADVANCED_FACE" in kinds
    rgb = np.array([entity.values[1:] for _, entity in step.all("COLOUR_RGB")], dtype=float)
    assert len(np.unique(rgb, axis=0)) >= 2 and rgb.min() >= 0 and rgb.max() <= 1
    for _, entity in styled:
        reached = _reached(step, entity.values[1])
        assert reached & {"COLOUR_RGB", "DRAUGHTING_PRE_DEFINED_COLOUR"}


def _reached(step: StepText, start: Any) -> set[str]:
    waiting, kinds = list(refs(start)), set()
    while waiting:
        entity = step.data[waiting.pop()]
        kinds |= set(entity.parts)
        waiting += refs(list(entity.parts.values()))
    return kinds


def test_shells_are_closed_and_their_loops_too(case: tuple[str, StepText]) -> None:
    """Every edge is used twice, once in either sense, and every loop comes back to where it began."""
    _, step = case
    for _, solid in step.all("MANIFOLD_SOLID_BREP"):
        uses: Counter[tuple[int, bool]] = Counter()
        for face in step.get(solid.values[1]).values[1]:
            _, bounds, surface, _ = step.get(face).values
            assert step.get(surface).parts
            for bound in bounds:
                _, loop, upright = step.get(bound).values
                for edge, forward in _loop(step, step.get(loop)):
                    uses[edge, forward == (upright == Enum("T"))] += 1
        assert set(uses.values()) == {1}
        assert {(edge, not forward) for edge, forward in uses} == set(uses)


def _loop(step: StepText, loop: Entity) -> list[tuple[int, bool]]:
    """Edges of a loop and whether they are run forward."""
    assert loop.kind == "EDGE_LOOP"
    found, ends = [], []
    for ref in loop.values[1]:
        *_, edge, sense = step.get(ref).values
        start, stop = step.get(edge).values[1:3]
        forward = sense == Enum("T")
        ends.append((start, stop) if forward else (stop, start))
        found.append((edge.number, forward))
    assert all(here[1] == there[0] for here, there in zip(ends, [*ends[1:], ends[0]], strict=True))
    return found


def test_splines_have_as_many_knots_as_poles_ask_for(case: tuple[str, StepText]) -> None:
    _, step = case
    curves, surfaces = step.all("B_SPLINE_CURVE_WITH_KNOTS"), step.all("B_SPLINE_SURFACE_WITH_KNOTS")
    assert curves and surfaces
    for _, entity in curves:
        _, degree, poles, _, _, _, counts, knots, _ = entity.values
        _check_knots(degree, len(poles), counts, knots)
    for _, entity in surfaces:
        _, degree_u, degree_v, rows, *_, counts_u, counts_v, knots_u, knots_v, _ = entity.values
        _check_knots(degree_u, len(rows), counts_u, knots_u)
        _check_knots(degree_v, len(rows[0]), counts_v, knots_v)


def _check_knots(degree: int, poles: int, counts: list[int], knots: list[float]) -> None:
    assert sum(counts) == poles + degree + 1
    assert counts[0] == counts[-1] == degree + 1 and max(counts[1:-1], default=1) <= degree
    assert all(isinstance(knot, float) for knot in knots) and np.all(np.diff(knots) > 0)


def test_edges_begin_and_end_in_vertices_on_their_curves(case: tuple[str, StepText]) -> None:
    name, step = case
    near = 1e-4 / (25.4 if "inch" in name else 1.0)
    looked_at = 0
    for _, edge in step.all("EDGE_CURVE"):
        _, first, last, curve, _ = edge.values
        geometry = step.get(curve)
        if geometry.kind == "B_SPLINE_CURVE_WITH_KNOTS" and looked_at < 60:
            looked_at += 1
            _, degree, poles, _, _, _, counts, knots, _ = geometry.values
            spline = BSpline(np.repeat(knots, counts), np.array([_point(step, pole) for pole in poles]), degree)
            for vertex in (first, last):
                assert _distance(spline, _point(step, step.get(vertex).values[1])) < near
    assert looked_at


def _distance(spline: BSpline, point: np.ndarray) -> float:
    """Of a point from a curve."""
    low, high = spline.t[0], spline.t[-1]
    for _ in range(4):
        t = np.linspace(low, high, 201)
        off = np.linalg.norm(spline(t) - point, axis=1)
        best, step = t[np.argmin(off)], t[1] - t[0]
        low, high = max(best - step, spline.t[0]), min(best + step, spline.t[-1])
    return float(off.min())


def _point(step: StepText, ref: Ref) -> np.ndarray:
    return np.array(step.get(ref).values[1], dtype=float)


def test_a_broken_text_is_noticed() -> None:
    good = (
        "ISO-10303-21;HEADER;FILE_NAME('a''b');ENDSEC;DATA;#1=A(#2,(1.,.T.),$);#2=(B()C('x'));ENDSEC;END-ISO-10303-21;"
    )
    step = parse(good)
    assert step.header["FILE_NAME"] == ["a'b"] and step.data[1].values == [Ref(2), [1.0, Enum("T")], None]
    for bad in (good.replace("#2=", "#1="), good.replace("$)", "$"), good[:-5], good.replace("1.,", "1.,,")):
        with pytest.raises(AssertionError):
            parse(bad)
