"""How well a few typed letters fit a title."""

from __future__ import annotations

from functools import cache

START, NEXT, WHOLE_WORD, GAP = 8, 6, 4, 1
_NONE = -(10**6)


def fit(typed: str, title: str) -> tuple[int, tuple[int, ...]] | None:
    """Score and places of the typed letters in a title, or None when they do not occur in this order.

    Letters at the start of words and letters that follow each other count most, so that ``bp`` and ``build p`` both
    find "Build pair"; blanks between the typed words are free, and each gap costs a little.
    """
    letters = "".join(typed.lower().split())
    text = title.lower()
    if len(text) != len(title) or len(letters) > len(text):
        return None
    starts = {i for i, letter in enumerate(text) if letter.isalnum() and (i == 0 or not text[i - 1].isalnum())}

    @cache
    def best(letter: int, place: int, follows: bool) -> tuple[int, tuple[int, ...]]:
        if letter == len(letters):
            return 0, ()
        found: tuple[int, tuple[int, ...]] = _NONE, ()
        for i in range(place, len(text)):
            if text[i] != letters[letter]:
                continue
            score, rest = best(letter + 1, i + 1, True)
            score += (START if i in starts else 0) + (NEXT if follows and i == place else -GAP * min(i - place, 5))
            if score > found[0]:
                found = score, (i, *rest)
        return found

    score, places = best(0, 0, False)
    return (score, places) if score > _NONE // 2 else None
