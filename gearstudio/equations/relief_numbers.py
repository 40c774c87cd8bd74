"""Numbers of the micro-geometry of a member's two flanks, D the drive flank and C the coast flank."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from gearstudio.equations.records import Given, Numbers, Subject, deg, mm, pure, um
from gearstudio.theory.relief import FlankRelief

_PARTS = (("c_l", "lengthwise_crown"), ("c_p", "profile_crown"), ("s", "spiral"), ("p", "pressure"), ("b", "bias"))
_PLACES = ((-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0))


def _flanks(s: Subject) -> Iterator[tuple[str, FlankRelief]]:
    """Drive and coast flank; one without micro-geometry takes nothing off."""
    concave, convex = (one or FlankRelief(s.member.relief_frame) for one in s.member.reliefs)
    drive_is_concave = s.member is s.pair.pinion
    yield from zip("DC", (concave, convex) if drive_is_concave else (convex, concave), strict=True)


def relief(s: Subject) -> Numbers:
    """What is taken off in the middle of the four edges."""
    given: list[Given] = []
    taken: list[Given] = []
    for name, flank in _flanks(s):
        given += [um(_indexed(symbol, name), getattr(flank, part)) for symbol, part in _PARTS]
        taken += [um(f"e_{name} ({x:.0f}, {y:.0f})", float(flank.over(x, y))) for x, y in _PLACES]
    return Numbers(tuple(given), tuple(taken))


def tip_relief(s: Subject) -> Numbers:
    """What the tip relief takes off at the tip."""
    flanks = tuple(_flanks(s))
    given = [one for n, f in flanks for one in (um(_indexed("c_t", n), f.tip), pure(_indexed("eta_t", n), f.tip_start))]
    return Numbers(tuple(given), tuple(um(f"e_(t {n}) (1)", f.tip) for n, f in flanks))


def root_relief(s: Subject) -> Numbers:
    """What the root relief takes off at the lower edge."""
    flanks = tuple(_flanks(s))
    given = [one for n, f in flanks for one in (um(_indexed("c_r", n), f.root), pure(_indexed("eta_r", n), f.root_end))]
    return Numbers(tuple(given), tuple(um(f"e_(r {n}) (-1)", f.root) for n, f in flanks))


def places(s: Subject) -> Numbers | None:
    """Where the pitch cone lies between the edges of the flank, in the middle of the face."""
    m, flank = s.member, next(iter(_flanks(s)))[1]
    if s.is_conjugate and m.reliefs == (None, None):
        return None
    frame, mean = flank.frame, np.asarray(flank.frame.mean_distance)
    low, tip = float(frame.low.at(mean)[0]), float(frame.tip.at(mean)[0])
    return Numbers(
        (
            mm("rho_u = R_m", frame.mean_distance),
            mm("B", 2 * frame.half_face),
            deg("delta_k = delta", m.pitch_angle),
            deg("delta_0", low),
            deg("delta_a", tip),
        ),
        (pure("xi", 0.0), pure("eta", 2 * (m.pitch_angle - low) / (tip - low) - 1)),
    )


def _indexed(symbol: str, name: str) -> str:
    head, _, index = symbol.partition("_")
    return f"{head}_({index} {name})" if index else f"{head}_{name}"
