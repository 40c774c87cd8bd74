"""What a contact analysis finds, as plain records."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from gearstudio.analysis.contact_path import ContactPath
from gearstudio.analysis.contact_placing import Misalignment
from gearstudio.analysis.contact_roll import Roll
from gearstudio.catalogue import MemberName
from gearstudio.errors import Issue
from gearstudio.theory.flank import FlankName

Floats = NDArray[np.float64]
Direction = Literal["drive", "coast"]
DIRECTIONS: tuple[Direction, Direction] = ("drive", "coast")


@dataclass(frozen=True)
class FlankPattern:
    """The contact pattern on one member's flank; arrays of shape (n_u, n_v), u root to tip, v toe to heel.

    Attributes
    ----------
    member : {"pinion", "wheel"}
    flank : {"concave", "convex"}
    points : ndarray, shape (n_u, n_v, 3)
        Of the tooth at azimuth 0 [mm]; on the wheel, where the pinion's points touch, so u runs tip to root.
    rho, delta_deg : ndarray
        Cone distance [mm] and polar angle [deg].
    gap_um : ndarray
        Least gap while the pair rolls; infinite where the mate has no flank.
    """

    member: MemberName
    flank: FlankName
    points: Floats
    rho: Floats
    delta_deg: Floats
    gap_um: Floats


@dataclass(frozen=True)
class FlankContact:
    """One direction of load: a pinion flank on a wheel flank.

    Attributes
    ----------
    direction : {"drive", "coast"}
    turn_deg, error_arcsec : ndarray, shape (n,)
        Transmission error over three pitches of the pinion, all teeth in mesh: the angle by which the wheel
        lags behind phi_1 z_1/z_2 (and the backlash), negative where it leads.
    peak_to_peak_arcsec : float
    roll : Roll
        One pair of teeth alone.
    pinion, wheel : FlankPattern
    ease_off_um, roll_deg : ndarray, shape (n_u, n_v)
        Metal missing from the wheel's conjugate flank at the points of the pinion, and the turn at which they
        touch: its contours are the lines of contact.
    path : ContactPath
    contact_ratio : float
        Turn of the pinion over which a pair of teeth shows contact within the marking thickness, in pitches.
    pattern_share : float
        Part of the meeting flank's grid that shows contact.
    pattern_centre : (float, float)
        Mean place of the pattern along the face (0 toe, 1 heel) and the profile (0 root, 1 tip) of the pinion.
    """

    direction: Direction
    turn_deg: Floats
    error_arcsec: Floats
    peak_to_peak_arcsec: float
    roll: Roll
    pinion: FlankPattern
    wheel: FlankPattern
    ease_off_um: Floats
    roll_deg: Floats
    path: ContactPath
    contact_ratio: float
    pattern_share: float
    pattern_centre: tuple[float, float]


@dataclass(frozen=True)
class ContactResult:
    """A contact analysis for drive (the pinion's concave flank leads) and coast."""

    misalignment: Misalignment
    thickness_um: float
    drive: FlankContact
    coast: FlankContact
    play_mm: float
    warnings: tuple[Issue, ...]

    def direction(self, name: Direction) -> FlankContact:
        """The side called ``"drive"`` or ``"coast"``."""
        return self.drive if name == "drive" else self.coast
