"""Point clouds of a flank as text: ``dat`` (the paper's), ``ibl`` (blend curves), ``csv`` (with normals)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from gearstudio.theory.cloud import Spacing, flank_coordinates
from gearstudio.theory.flank import Flank

Floats = NDArray[np.float64]
PointFormat = Literal["dat", "ibl", "csv"]
POINT_FORMATS: tuple[PointFormat, ...] = get_args(PointFormat)
CSV_HEADER = "x,y,z,nx,ny,nz,rho,delta_deg"


@dataclass(frozen=True)
class PointCloud:
    """Points of a theoretical flank, rows from toe to heel, columns from root (or base cone) to tip.

    Attributes
    ----------
    points : ndarray, shape (rows, cols, 3)
        [mm].
    normals : ndarray, shape (rows, cols, 3)
        Unit vectors out of the metal.
    rho, polar_angle : ndarray, shape (rows, cols)
        Cone distance [mm] and delta_k [rad].
    """

    points: Floats
    normals: Floats
    rho: Floats
    polar_angle: Floats


def point_cloud(flank: Flank, rows: int, cols: int, spacing: Spacing) -> PointCloud:
    """The points of `theory.cloud.flank_grid` with their normals; raises GeometryError as it does."""
    rho, delta = flank_coordinates(flank, rows, cols, spacing)
    normals = flank.normals_at(*flank.natural_at(rho, delta))
    return PointCloud(flank.points_at(rho, delta), normals, rho, delta)


def points_text(cloud: PointCloud, format_: PointFormat) -> str:
    """A point cloud as the text of a file; every number reads back exactly."""
    writers: dict[PointFormat, Callable[[PointCloud], Iterable[str]]] = {"dat": _dat, "ibl": _ibl, "csv": _csv}
    return "\n".join(writers[format_](cloud)) + "\n"


def _dat(cloud: PointCloud) -> Iterator[str]:
    yield from (_numbers(point, " ") for point in cloud.points.reshape(-1, 3))


def _ibl(cloud: PointCloud) -> Iterator[str]:
    yield "Open Index arclength"
    for index, row in enumerate(cloud.points, start=1):
        yield f"Begin section ! {index}"
        yield f"Begin curve ! {index}"
        yield from (_numbers(point, " ") for point in row)


def _csv(cloud: PointCloud) -> Iterator[str]:
    yield CSV_HEADER
    places = np.stack([cloud.rho, np.degrees(cloud.polar_angle)], axis=-1)
    table = np.concatenate([cloud.points, cloud.normals, places], axis=-1)
    yield from (_numbers(line, ",") for line in table.reshape(-1, 8))


def _numbers(values: Floats, separator: str) -> str:
    return separator.join(f"{value:.17g}" for value in values)
