"""The paper's three ways to model a flank, behind one face; nobody else needs to know which is which."""

from gearstudio.methods.base import VARIANTS, Construction, Method, Target
from gearstudio.methods.point_cloud import POINT_CLOUD
from gearstudio.methods.profile_sweep import PROFILE_SWEEP
from gearstudio.methods.rotating_line import ROTATING_LINE

METHODS: tuple[Method, ...] = (ROTATING_LINE, PROFILE_SWEEP, POINT_CLOUD)


def method(method_id: str) -> Method:
    """The method of an id of interface.md; KeyError for an unknown one."""
    return {m.id: m for m in METHODS}[method_id]


__all__ = ["METHODS", "VARIANTS", "Construction", "Method", "Target", "method"]
