"""Rolling: no error of transmission and no interference, whatever the hand, the sign and the curve."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearstudio.theory.hypoid.inputs import HypoidInput
from gearstudio.theory.hypoid.pair import HypoidPair
from tests.theory.hypoid.pairs import PAIRS, PRESETS, random_pairs, sound_pair
from tests.theory.hypoid.rolling import ARCSEC, roll


def assert_rolls(pair: HypoidPair, positions: int) -> None:
    """Both sides touch at exactly the backlash, and never cross."""
    for side in (1, -1):
        rolled = roll(pair, side, positions)
        assert np.abs(np.array(rolled.error) - 2 * pair.backlash_azimuth).max() < 1e-4 * ARCSEC
        assert rolled.overlap > -1e-9


@pytest.mark.parametrize("hand", ["left", "right"])
@pytest.mark.parametrize("given", (PAIRS | PRESETS).values(), ids=PAIRS | PRESETS)
def test_typical_pairs(given: HypoidInput, hand: str) -> None:
    assert_rolls(sound_pair(replace(given, pinion_hand=hand)), 5)


def test_random_pairs() -> None:
    for pair in random_pairs(4, 2):
        assert_rolls(pair, 4)


@pytest.mark.slow
def test_fifty_random_pairs() -> None:
    for pair in random_pairs(50, 11):
        assert_rolls(pair, 7)
