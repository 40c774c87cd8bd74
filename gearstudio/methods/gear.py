"""A whole gear: every tooth of a method and variant joined with the turned body into one solid."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from gearstudio.catalogue import Variant
from gearstudio.design import Design
from gearstudio.errors import GeometryError, ModellingError
from gearstudio.kernel.shell import GearShell, assembled
from gearstudio.kernel.solids import check_solid, is_valid
from gearstudio.methods.base import Target
from gearstudio.methods.tooth import Tooth, build_tooth
from gearstudio.results import FaceResult, MassProperties, SolidResult
from gearstudio.theory.blank import BlankOutline, BlankSizes, blank_outline
from gearstudio.theory.cones import MemberGeometry, pair_geometry


@dataclass(frozen=True)
class Gear:
    """A member's solid and what it was made from."""

    member: MemberGeometry
    tooth: Tooth
    outline: BlankOutline
    shell: GearShell


def target_of(design: Design, member: MemberGeometry) -> Target:
    """What the optimised variants of a design have to reach."""
    return Target.for_cone_distance(
        design.methods.tolerance_um, member.outer_cone_distance, design.methods.point_cloud_degree
    )


def blank_sizes(design: Design, member: str) -> BlankSizes:
    """The sizes of a member's body as the design gives them."""
    return BlankSizes(**getattr(design.blank, member).model_dump())


def build_gear(design: Design, member: str, method_id: str, variant: Variant) -> Gear:
    """Assemble a member: no Boolean on teeth, every edge shared.

    Raises
    ------
    BlankError
        A size of the body that cannot be made.
    ModellingError
        The method could not make the tooth.
    """
    geometry = pair_geometry(design).member(member)
    outline = blank_outline(geometry, blank_sizes(design, member))
    try:
        tooth = build_tooth(geometry, method_id, variant, target_of(design, geometry))
    except GeometryError as error:
        raise ModellingError(method_id, f"{variant} tooth of the {member}", str(error)) from error
    surfaces = [face.surface for face in tooth.faces]
    shell = assembled(surfaces, geometry.teeth, outline.points, geometry.ends == "sphere")
    return Gear(geometry, tooth, outline, shell)


def solid_result(
    design: Design,
    member: str,
    method_id: str,
    variant: Variant,
    construction: str,
    report: Callable[[str, float], None],
) -> SolidResult:
    """Build a member's solid, check it and weigh it; ``report(stage, fraction)`` tells how far it is.

    Raises
    ------
    BlankError, ModellingError
        As `build_gear`.
    """
    report("building", 0.0)
    started = time.perf_counter()
    gear = build_gear(design, member, method_id, variant)
    report("checking", 0.3)
    valid = is_valid(gear.shell.solid)
    seconds = time.perf_counter() - started
    report("weighing", 0.5)
    check = check_solid(gear.shell.solid)
    return SolidResult(
        member=member,
        method=method_id,
        variant=variant,
        construction=construction,
        teeth=gear.member.teeth,
        faces=tuple(FaceResult(face.kind, face.side, face.surface) for face in gear.tooth.faces),
        outline=gear.outline.points,
        spherical_ends=gear.member.ends == "sphere",
        valid=valid,
        closed=check.closed,
        face_count=check.faces,
        gap=gear.shell.tolerance,
        properties=MassProperties(check.volume, check.area, check.centre, check.inertia),
        box=check.box,
        seconds=seconds,
    )
