"""The paper's three ways to model a flank, behind one face; nobody else needs to know which is which."""

from gearstudio.methods.base import Construction, Method, Target
from gearstudio.methods.point_cloud import PointCloud
from gearstudio.methods.profile_sweep import ProfileSweep
from gearstudio.methods.rotating_line import RotatingLine

METHODS: tuple[Method, ...] = (RotatingLine(), ProfileSweep(), PointCloud())


def method(method_id: str) -> Method:
    """The method of an id of the catalogue; KeyError for an unknown one."""
    return {m.info.id: m for m in METHODS}[method_id]


__all__ = ["METHODS", "Construction", "Method", "Target", "method"]
