"""Identity of the compiled library: only the same build computes bit-identical commands."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

from surefoot import _core


@cache
def build_id() -> str:
    """Return 16 hexadecimal digits that identify the bytes of the compiled library.

    The digits do not depend on the processor. On another processor the mathematics library of the
    system may use other instructions, which round differently, so commands may differ despite an
    equal build_id().
    """
    module = Path(_core.__file__)
    digest = hashlib.sha256(module.read_bytes())
    for library in sorted((module.parent / "lib").glob("libsurefoot.*")):
        digest.update(library.read_bytes())
    return digest.hexdigest()[:16]
