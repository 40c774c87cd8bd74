"""Rules of fillets that follow a root cone with an apex of its own: whether there are any, and of what size."""

from __future__ import annotations

from collections.abc import Iterator

from gearstudio.design import Design, all_field_specs, with_field
from gearstudio.errors import GeometryError
from gearstudio.theory.cones import MemberGeometry
from gearstudio.theory.hypoid.fillets import FilletError
from gearstudio.theory.hypoid.profile import HypoidProfile
from gearstudio.theory.profile import profile_of
from gearstudio.validation.nearest import Cure, cure, offer, round_toward
from gearstudio.validation.patience import seconds_left
from gearstudio.validation.rule import Finding, Rule, geometry, members, present

_FIELD = "tooth.fillet_factor"
_SCAN = 6
_SAME = 0.002
_UNHURRIED_S = 1.0
_TRIES = 4
_INPUTS = frozenset(
    path
    for path in all_field_specs()
    if path.split(".")[0] in ("pair", "lengthwise", "tooth", "depth", "modifications")
)


def _fillets(design: Design) -> Iterator[Finding]:
    for member in members(design):
        error = _no_profile(member)
        if error is None:
            continue
        found = _remedy(design, member, error)
        value, field = present(design, found.field or _FIELD), found.field or _FIELD
        if found.text:
            yield Finding(field, f"{value} leaves the {member.name} no root: {error.reason}; use {found.text}")
        else:
            yield Finding(field, f"{value} leaves the {member.name} no root: {error.reason}; {error.remedy}")


def _remedy(design: Design, member: MemberGeometry, error: FilletError) -> Cure:
    """The largest fillet that can be, where the theory tells it, and the clearance with which the one asked for can."""

    def works(changed: Design) -> bool:
        return _no_profile(geometry(changed).member(member.name)) is None

    offers, field = [], ""
    factor = _largest(design, member.name, error)
    if factor is not None:
        offers, field = [offer(design, _FIELD, factor)], _FIELD
    if field and seconds_left() < _UNHURRIED_S:
        return Cure(offers[0], field)
    others = [] if field else [(_FIELD, 0.01)]
    found = cure(design, works, [*others, ("tooth.clearance_factor", 0.5), ("tooth.clearance_factor", 0.05)], _SCAN)
    offers += [found.text] if found.text else []
    return Cure(" or ".join(offers), field or found.field)


def _largest(design: Design, name: str, error: FilletError) -> float | None:
    """The largest fillet factor that both flanks of a member permit, where the theory tells it."""
    least = all_field_specs()[_FIELD].minimum or 0.0
    for _ in range(_TRIES):
        if error.largest is None:
            return None
        whole = geometry(design).member(name).fillet_radius / design.tooth.fillet_factor
        factor = round_toward(error.largest / whole, up=False)
        if factor < least:
            return None
        design = with_field(design, _FIELD, factor)
        other = _no_profile(geometry(design).member(name))
        if other is None:
            return factor
        error = other
    return None


def _resized(design: Design) -> Iterator[Finding]:
    for member in members(design):
        profile = profile_of(member)
        if not isinstance(profile, HypoidProfile):
            continue
        made, wanted = profile.fillet_radius, member.fillet_radius
        if abs(made - wanted) > _SAME * wanted:
            factor = round_toward(design.tooth.fillet_factor * made / wanted, up=made > wanted)
            yield Finding(
                _FIELD,
                f"{present(design, _FIELD)} asks for fillets of {wanted:.4g} mm on the {member.name}, which do not fit "
                f"between its flanks and its root; they get {made:.4g} mm, as with a fillet factor of {factor:.4g}",
            )


def _no_profile(member: MemberGeometry) -> FilletError | None:
    try:
        profile_of(member)
    except FilletError as error:
        return error
    except GeometryError as error:
        return FilletError(str(error), "use a larger clearance or shallower teeth")
    return None


_TEETH = frozenset({"derivable", "no_thickness", "pointed_tip", "no_space"})
FILLETS = Rule("fillet", "error", _INPUTS, _TEETH, _FIELD, _fillets)
RESIZED = Rule("fillet_size", "warning", _INPUTS, FILLETS.needs | {FILLETS.code}, _FIELD, _resized)
