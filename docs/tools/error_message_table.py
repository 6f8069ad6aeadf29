# SPDX-License-Identifier: BSD-3-Clause
"""Print a table of all error messages: text, where it is raised, and what to do.

    python docs/tools/error_message_table.py > out/messages.md

It reads the sources: `raise Error(...)` in bindings/surefoot, `throw Error(...)` in controller/src
and bindings/src. Values that a message inserts stand in angle brackets.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
THROW = re.compile(r"throw (?:surefoot::)?Error\((?P<text>.*?)\);", re.DOTALL)
LITERAL = re.compile(r'"((?:\\.|[^"\\])*)"')
ADVICE = (
    r"expected|valid \w+:|pip install|install|give|ask for|use (?:a|easier)|choose|try|start"
    r"|the model has"
)
REMEDY = re.compile(rf"(?:, |; |: )?(?=\b(?:{ADVICE}))")
PASSED_ON = re.compile(r"<[^<>]*(?:problem|reason|error|text|what|report|stderr|why)[^<>]*>\)?$")


@dataclass(frozen=True)
class Message:
    """One error message.

    Attributes:
        text: With <expression> for inserted values.
        source: File that raises it, from the root of the repository.
    """

    text: str
    source: str

    @property
    def remedy(self) -> str:
        """What the user should do: the part of the text from "expected" on; "" if none."""
        parts = REMEDY.split(self.text, maxsplit=1)
        return parts[1] if len(parts) > 1 else ""

    @property
    def passed_on(self) -> bool:
        """Whether it ends with the text of another error, which says what to do."""
        return PASSED_ON.search(self.text) is not None


def python_messages() -> Iterator[Message]:
    """Yield the messages of every `raise Error(...)` of the Python package."""
    for path in sorted((ROOT / "bindings" / "surefoot").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and node.exc.args:
                name = node.exc.func
                if isinstance(name, ast.Name) and name.id == "Error":
                    yield Message(_python_text(node.exc.args[0]), str(path.relative_to(ROOT)))


def cpp_messages() -> Iterator[Message]:
    """Yield the messages of every `throw Error(...)` of the library and its bindings."""
    for folder in (ROOT / "controller" / "src", ROOT / "bindings" / "src"):
        for path in sorted(folder.rglob("*.?pp")):
            for match in THROW.finditer(path.read_text()):
                yield Message(_cpp_text(match["text"]), str(path.relative_to(ROOT)))


def _python_text(node: ast.expr) -> str:
    if isinstance(node, ast.Constant):
        return str(node.value)
    if isinstance(node, ast.JoinedStr):
        return "".join(_python_text(part) for part in node.values)
    if isinstance(node, ast.FormattedValue):
        return f"<{ast.unparse(node.value)}>"
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return _python_text(node.left) + _python_text(node.right)
    return f"<{ast.unparse(node)}>"


def _cpp_text(expression: str) -> str:
    """Join the literals of a C++ expression; what is added between them goes in brackets."""
    text, end = "", 0
    for match in LITERAL.finditer(expression):
        between = re.sub(r"\s+", " ", expression[end : match.start()]).strip(" +")
        text += (f"<{between}>" if between else "") + match[1]
        end = match.end()
    rest = re.sub(r"\s+", " ", expression[end:]).strip(" +")
    return (text + (f"<{rest}>" if rest else "")).replace('\\"', '"').replace("\\n", " ")


def all_messages() -> list[Message]:
    """Return every message once, in alphabetical order."""
    return sorted({*python_messages(), *cpp_messages()}, key=lambda m: (m.text.lower(), m.source))


def table(messages: list[Message]) -> str:
    """Return the messages as a Markdown table."""
    lines = ["# Messages", "", "| message | raised in | what to do |", "|---|---|---|"]
    for message in messages:
        text, remedy = (part.replace("|", "\\|") for part in (message.text, message.remedy))
        lines.append(f"| `{text}` | {message.source} | {remedy} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(table(all_messages()), end="")
