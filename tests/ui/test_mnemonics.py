"""Letters that call the entries of a menu: each once, whatever the translator wrote."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from ui.mnemonics import distinct, mark

WORDS = st.text("abcdefgABÄöü ", min_size=1, max_size=8)


@st.composite
def entries(draw: st.DrawFn) -> str:
    words = draw(WORDS)
    at = draw(st.integers(-1, len(words) - 1))
    return words if at < 0 or words[at] == " " else f"{words[:at]}&{words[at:]}"


@given(st.lists(entries(), max_size=12))
def test_no_letter_calls_two_entries_and_no_word_changes(texts: list[str]) -> None:
    made = distinct(texts)
    letters = [mark(text) for text in made if mark(text)]
    assert len(letters) == len(set(letters))
    assert [text.replace("&", "") for text in made] == [text.replace("&", "") for text in texts]
    assert all(bool(mark(old)) or not mark(new) for old, new in zip(texts, made, strict=True))
    first = {mark(text): text for text in reversed(texts) if mark(text)}
    assert all(made[texts.index(text)] == text for text in first.values()), "the first one keeps its letter"


def test_letters_beside_chinese_words_and_doubled_signs() -> None:
    assert distinct(["保存(&S)", "示例(&S)"]) == ["保存(&S)", "示例(&A)"]
    assert distinct(["&Save", "&Samples", "&Salt && so"]) == ["&Save", "S&amples", "Sa&lt && so"]
    assert distinct(["&Reset all", "&Reset field"]) == ["&Reset all", "Reset &field"]
    assert distinct(["&A", "&a", "&A"]) == ["&A", "a", "A"]
