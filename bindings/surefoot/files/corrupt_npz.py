"""Exceptions that numpy and the modules below it raise for corrupt NPZ files."""

from __future__ import annotations

import tokenize
import zipfile
import zlib

CORRUPT_NPZ = (
    ValueError,
    KeyError,  # a missing array
    EOFError,
    RuntimeError,  # includes NotImplementedError: an unknown compression method
    zipfile.BadZipFile,
    zlib.error,
    # numpy parses an array's header as a Python literal before zipfile checks the CRC.
    tokenize.TokenError,
    SyntaxError,
    TypeError,
    OverflowError,
    MemoryError,
)
