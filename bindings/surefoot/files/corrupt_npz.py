"""What numpy and the modules below it raise at NPZ files that are damaged."""

from __future__ import annotations

import tokenize
import zipfile
import zlib

CORRUPT_NPZ = (
    ValueError,
    KeyError,  # an array that is missing
    EOFError,
    RuntimeError,  # NotImplementedError is one: a compression that there is not
    zipfile.BadZipFile,
    zlib.error,
    # An array's header is Python text, and read before any sum is checked.
    tokenize.TokenError,
    SyntaxError,
    TypeError,
    OverflowError,
    MemoryError,
)
