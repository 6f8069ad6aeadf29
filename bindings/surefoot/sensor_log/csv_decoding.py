"""Decode the bytes of a CSV file to text."""

from __future__ import annotations

import codecs

from surefoot._core import Error

# UTF-32 before UTF-16: the mark of UTF-32 LE begins with that of UTF-16 LE.
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_SAMPLE = 4096  # bytes that decide whether a file without a mark is UTF-16
_UNIT_BYTES = {"utf-16-le": 2, "utf-16-be": 2, "utf-32-le": 4, "utf-32-be": 4}


def decode_csv(source: str, data: bytes) -> tuple[str, list[str]]:
    """Return the text of a file, with line ends as newlines, and notes about what was converted.

    UTF-8, UTF-16 and UTF-32 are read, the latter two with a byte order mark. Other bytes are read
    as Latin-1, which leaves numbers and ASCII names as they are. NUL characters at the end, which
    a loss of power leaves in a file, are removed.

    Raises:
        Error: The text contains NUL characters before its end.
    """
    notes = []
    encoding, mark = _encoding(data)
    data = data[mark:]
    data = data[: len(data) - len(data) % _UNIT_BYTES.get(encoding, 1)]
    try:
        text = data.decode(encoding)
    except UnicodeDecodeError as problem:
        line = data.count(b"\n", 0, problem.start) + 1
        notes.append(f"line {line}: bytes that are not {encoding.upper()} are read as Latin-1")
        text = data.decode("latin-1")
    if encoding != "utf-8":
        notes.append(f"the file is read as {encoding.upper()}")
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    kept = text.rstrip("\0")
    if len(kept) < len(text):
        notes.append(f"{len(text) - len(kept)} NUL characters at the end of the file are removed")
    nul = kept.find("\0")
    if nul >= 0:
        raise Error(
            f"{source}: line {kept.count(chr(10), 0, nul) + 1}: got a NUL character, expected text "
            "in UTF-8 or UTF-16; is it a binary file?"
        )
    return kept, notes


def _encoding(data: bytes) -> tuple[str, int]:
    """Return the encoding of a file, and the number of bytes of its byte order mark."""
    for mark, encoding in _MARKS:
        if data.startswith(mark):
            return encoding, len(mark)
    # ASCII text in UTF-16 has a NUL in every other byte.
    even, odd = data[:_SAMPLE:2], data[1:_SAMPLE:2]
    if odd.count(0) > 0.9 * len(odd) and 0 not in even:
        return "utf-16-le", 0
    if even.count(0) > 0.9 * len(even) and 0 not in odd:
        return "utf-16-be", 0
    return "utf-8", 0
