"""Identity of the build of the library: commands are bit-identical only on the same build."""

from __future__ import annotations

import hashlib
from functools import cache
from pathlib import Path

from surefoot import _core


@cache
def build_id() -> str:
    """Return 16 hexadecimal digits that identify the bytes of the compiled library.

    The processor is not included. On another processor the system's mathematics library may use
    other instructions, which round differently.
    """
    module = Path(_core.__file__)
    digest = hashlib.sha256(module.read_bytes())
    for library in sorted((module.parent / "lib").glob("libsurefoot.*")):
        digest.update(library.read_bytes())
    return digest.hexdigest()[:16]
