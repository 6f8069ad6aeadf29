# SPDX-License-Identifier: BSD-3-Clause
"""Every error message says what to do; docs/tools/error_message_table.py lists them all."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).parents[2] / "docs" / "tools" / "error_message_table.py"


@pytest.fixture(scope="module")
def messages() -> ModuleType:
    spec = importlib.util.spec_from_file_location("messages", SCRIPT)
    assert spec is not None and spec.loader is not None
    module = sys.modules[spec.name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_message_says_what_to_do(messages: ModuleType) -> None:
    found = messages.all_messages()
    assert len(found) > 250  # both languages were read
    assert [m for m in found if not m.remedy and not m.passed_on] == []


def test_table_has_a_row_for_every_message(messages: ModuleType) -> None:
    found = messages.all_messages()
    assert messages.table(found).count("\n| `") == len(found)


def test_message_without_advice_is_noticed(messages: ModuleType) -> None:
    bad = messages.Message("gait: got <name>", "file.py")
    assert bad.remedy == "" and not bad.passed_on
    good = messages.Message("gait: got <name>, expected trot", "file.py")
    assert good.remedy == "expected trot"
