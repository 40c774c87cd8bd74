"""A whole gear: every tooth of a method and variant joined with the turned body into one solid."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, replace

from gearstudio.catalogue import Variant
from gearstudio.design import Design
from gearstudio.errors import GeometryError, ModellingError
from gearstudio.kernel.convert import CONFUSION_MM
from gearstudio.kernel.cutting import Face, Report, Solid
from gearstudio.kernel.shell import assembled
from gearstudio.kernel.solids import check_solid, is_valid
from gearstudio.methods.base import Target
from gearstudio.methods.cut import body_titles, cut_gear, cut_names
from gearstudio.methods.tooth import Tooth, build_tooth
from gearstudio.results import FaceResult, MassProperties, SolidResult
from gearstudio.theory.blank import BlankOutline, BlankSizes, blank_outline
from gearstudio.theory.chamfer import end_chamfers
from gearstudio.theory.cones import MemberGeometry, pair_geometry

_SIZE_SHARE = 4e-6
_BUILT = {"assemble": 0.3, "cut": 0.8}


@dataclass(frozen=True)
class Gear:
    """A member's solid and what it was made from.

    ``faces`` are all by name ("tooth 7 concave", "tooth 7 heel chamfer", teeth counted from 1 at azimuth 0;
    "heel end", "body 1" and on from there, "toe end"); ``gap`` is the largest between neighbouring faces [mm].
    """

    member: MemberGeometry
    tooth: Tooth
    outline: BlankOutline
    solid: Solid
    faces: tuple[tuple[str, Face], ...]
    gap: float


def target_of(design: Design, member: MemberGeometry) -> Target:
    """What the optimised variants of a design have to reach.

    At most a share of radius and face width: else the volume of a small gear misses theory by up to 1e-6 and more.
    """
    target = Target.for_cone_distance(
        design.methods.tolerance_um, member.outer_cone_distance, design.methods.point_cloud_degree
    )
    size = min(member.outer_cone_distance * math.sin(member.pitch_angle), member.face_width)
    return replace(target, tolerance=min(target.tolerance, max(_SIZE_SHARE * size, CONFUSION_MM)))


def blank_sizes(design: Design, member: str) -> BlankSizes:
    """The sizes of a member's body as the design gives them."""
    return BlankSizes(**getattr(design.blank, member).model_dump())


def ignore(stage: str, fraction: float) -> None:
    """A report that nobody reads."""


def design_tooth(design: Design, member: str, method_id: str, variant: Variant) -> Tooth:
    """One tooth of a member with its chamfers; ModellingError when the method could not make it."""
    geometry = pair_geometry(design).member(member)
    chamfers = end_chamfers(geometry, blank_sizes(design, member).end_chamfer)
    try:
        return replace(build_tooth(geometry, method_id, variant, target_of(design, geometry)), chamfers=chamfers)
    except GeometryError as error:
        raise ModellingError(method_id, f"{variant} tooth of the {member}", str(error)) from error


def build_gear(
    design: Design,
    member: str,
    method_id: str,
    variant: Variant,
    construction: str = "assemble",
    report: Report = ignore,
) -> Gear:
    """Make a member's solid.

    Parameters
    ----------
    design : Design
    member : {"pinion", "wheel"}
    method_id, variant : str
    construction : {"assemble", "cut"}
        Faces joined by shared edges, no Boolean; or, as in the paper, tooth spaces cut from the blank.
    report : callable
        Takes the stage that begins and the fraction done.

    Raises
    ------
    BlankError
        A size of the body that cannot be made.
    ModellingError
        The method could not make the tooth, or the Boolean failed.
    """
    geometry = pair_geometry(design).member(member)
    outline = blank_outline(geometry, blank_sizes(design, member))
    tooth = design_tooth(design, member, method_id, variant)
    if construction == "cut":
        try:
            cut = cut_gear(tooth, outline, target_of(design, geometry), report)
        except GeometryError as error:
            raise ModellingError(method_id, f"cutting of the {member}", str(error)) from error
        return Gear(geometry, tooth, outline, cut.solid, cut_names(tooth, outline, cut), cut.gap)
    report("joining the faces", 0.5)
    surfaces = [face.surface for face in tooth.faces]
    shell = assembled(surfaces, geometry.teeth, outline.points, geometry.ends == "sphere", outline.chamfers)
    titles = [*(face.title(geometry.hand) for face in tooth.faces), *(c.title for c in outline.chamfers)]
    made = zip(shell.tooth_faces, shell.chamfer_faces, strict=True)
    names = [
        (f"tooth {number} {title}", face)
        for number, (faces, chamfers) in enumerate(made, start=1)
        for title, face in zip(titles, (*faces, *chamfers), strict=True)
    ]
    names += zip(body_titles(len(shell.body_faces)), shell.body_faces, strict=True)
    return Gear(geometry, tooth, outline, shell.solid, tuple(names), shell.tolerance)


def solid_result(
    design: Design,
    member: str,
    method_id: str,
    variant: Variant,
    construction: str,
    report: Report,
) -> SolidResult:
    """Build a member's solid, check it and weigh it; ``report(stage, fraction)`` tells how far it is.

    Raises
    ------
    BlankError, ModellingError
        As `build_gear`.
    """
    report("building", 0.0)
    started = time.perf_counter()
    built = _BUILT[construction]
    gear = build_gear(
        design, member, method_id, variant, construction, lambda stage, share: report(stage, built * share)
    )
    report("checking", built)
    valid = is_valid(gear.solid)
    seconds = time.perf_counter() - started
    report("weighing", (1 + built) / 2)
    check = check_solid(gear.solid)
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
        gap=gear.gap,
        properties=MassProperties(check.volume, check.area, check.centre, check.inertia),
        box=check.box,
        seconds=seconds,
        end_chamfer=gear.outline.sizes.end_chamfer,
    )
