"""Reader of XML files that a user names: URDF and SRDF."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

from surefoot._core import Error
from surefoot.files.input_file import read_input_file

# Chosen: a hundred times the URDF of a robot with arms. If larger: a mesh or a log that is named by
# mistake takes seconds to be refused.
_MAX_BYTES = 16 << 20


class _Builder(ET.TreeBuilder):
    """Builder that refuses document types, because their entities can grow without bound."""

    def doctype(self, name: str, pubid: str | None, system: str | None) -> None:
        raise Error(f"got <!DOCTYPE {name}>, expected no document type; remove it")


def read_xml(path: Path, kind: str, root_tag: str = "robot") -> ET.Element:
    """Return the root element of an XML file.

    Args:
        path: The file.
        kind: What the file is, for messages, such as "URDF".
        root_tag: Expected name of the root element.

    Raises:
        Error: The file cannot be read, is not XML, has a document type, or has another root.
    """
    data = read_input_file(path, kind, _MAX_BYTES)
    if not data.strip():
        raise Error(f"{kind} '{path}': got an empty file, expected <{root_tag}>")
    try:
        root: ET.Element = ET.fromstring(data, ET.XMLParser(target=_Builder()))
    except ET.ParseError as problem:
        raise Error(f"'{path}' is not a {kind}: {problem}") from None
    except (LookupError, ValueError) as problem:  # an unknown or wrong encoding
        raise Error(f"'{path}' is not a {kind}: encoding: {problem}") from None
    except RecursionError:
        raise Error(
            f"'{path}' is not a {kind}: got elements nested too deeply, expected <{root_tag}>"
        ) from None
    except Error as problem:
        raise Error(f"{kind} '{path}': {problem}") from None
    if root.tag != root_tag:
        raise Error(f"{kind} '{path}': got <{root.tag}>, expected <{root_tag}>")
    return root
