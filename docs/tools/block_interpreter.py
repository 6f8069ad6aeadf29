# SPDX-License-Identifier: BSD-3-Clause
"""Execute the python blocks of a page in one namespace, for block_runner.

Reads from stdin, for each block, its number of lines and then its lines. Answers on stdout with one
line: "ok", or the error. What the blocks print goes to stderr's place, which nobody reads.
"""

from __future__ import annotations

import os
import sys


def main() -> None:
    """Execute blocks until stdin ends."""
    answers = os.fdopen(os.dup(1), "w")
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    sys.path.insert(0, os.getcwd())
    namespace: dict[str, object] = {"__name__": "__main__"}
    while count := sys.stdin.readline():
        text = "".join(sys.stdin.readline() for _ in range(int(count)))
        try:
            exec(compile(text, "block", "exec"), namespace)
        except (Exception, SystemExit) as error:
            line = str(error).splitlines()[:1]
            answer = f"{type(error).__name__}: {line[0] if line else ''}"
        else:
            answer = "ok"
        answers.write(answer + "\n")
        answers.flush()


if __name__ == "__main__":
    main()
