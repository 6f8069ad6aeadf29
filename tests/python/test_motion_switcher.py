# SPDX-License-Identifier: BSD-3-Clause
"""Client of the motion switcher: slow and busy switchers."""

from __future__ import annotations

import json
from collections.abc import Iterator

import pytest
import surefoot
from surefoot.motion_switcher import Api, Code, MotionSwitcher

TIMES = {"timeout": 0.05, "period": 0.001}  # [s]


class FakeClient:
    """A switcher without DDS: answers requests with given codes, changes its mode after checks.

    Args:
        mode: Mode at the start.
        codes: Codes of the replies to requests of a mode, in order; then OK.
        checks: Number of checks after which an accepted request acts.
        check_codes: Codes of the replies to CheckMode, in order; then OK.
    """

    def __init__(
        self, mode: str, codes: tuple[int, ...] = (), checks: int = 0,
        check_codes: tuple[int, ...] = (),
    ) -> None:  # fmt: skip
        self.mode, self.target, self.checks = mode, mode, checks
        self.codes: Iterator[int] = iter(codes)
        self.check_codes: Iterator[int] = iter(check_codes)
        self.calls: list[int] = []
        self.timeouts: set[float] = set()

    def call(
        self, api: int, parameter: str, timeout: float, repeat: bool = False
    ) -> tuple[int, str]:
        self.calls.append(api)
        self.timeouts.add(timeout)
        if api == Api.CHECK_MODE:
            if (code := next(self.check_codes, Code.OK)) != Code.OK:
                return code, ""
            if self.mode != self.target:
                self.checks -= 1
            if self.checks <= 0:
                self.mode = self.target
            return Code.OK, json.dumps({"form": "0", "name": self.mode})
        code = next(self.codes, Code.OK)
        if code in (Code.OK, Code.TIMEOUT):  # after a timeout the request may act all the same
            self.target = json.loads(parameter).get("name", "")
        return code, ""


def switcher(monkeypatch: pytest.MonkeyPatch, client: FakeClient) -> MotionSwitcher:
    monkeypatch.setattr(
        "surefoot.motion_switcher.client.DdsServiceClient", lambda network, service: client
    )
    return MotionSwitcher(None)  # type: ignore[arg-type]


def test_release_waits_for_replies_as_long_as_the_vendor(monkeypatch: pytest.MonkeyPatch) -> None:
    client = FakeClient("normal")
    assert switcher(monkeypatch, client).release(lambda _: None, **TIMES) == "normal"
    assert client.timeouts == {5.0}


def test_release_without_an_active_mode_sends_no_request(monkeypatch: pytest.MonkeyPatch) -> None:
    client, lines = FakeClient(""), list[str]()
    assert switcher(monkeypatch, client).release(lines.append, **TIMES) == ""
    assert client.calls == [Api.CHECK_MODE] and lines == []


def test_release_that_times_out_is_checked_and_not_repeated(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    client = FakeClient("normal", codes=(Code.TIMEOUT,), checks=4)
    assert switcher(monkeypatch, client).release(lambda _: None, **TIMES) == "normal"
    assert client.calls.count(Api.RELEASE_MODE) == 1
    assert client.mode == ""


def test_release_of_a_busy_switcher_is_repeated(monkeypatch: pytest.MonkeyPatch) -> None:
    client = FakeClient("normal", codes=(Code.BUSY, Code.BUSY))
    assert switcher(monkeypatch, client).release(lambda _: None, **TIMES) == "normal"
    assert client.calls.count(Api.RELEASE_MODE) == 3


def test_release_survives_checks_without_a_reply(monkeypatch: pytest.MonkeyPatch) -> None:
    client = FakeClient("normal", check_codes=(Code.OK, Code.TIMEOUT, Code.BUSY))
    assert switcher(monkeypatch, client).release(lambda _: None, **TIMES) == "normal"


def test_release_of_a_mode_that_stays_is_an_error_with_a_remedy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    client = FakeClient("normal", codes=(Code.TIMEOUT,), checks=10**6)
    with pytest.raises(surefoot.Error, match=r"got mode 'normal' 0.05 s after.*vendor's app"):
        switcher(monkeypatch, client).release(lambda _: None, **TIMES)


def test_release_that_is_refused_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    client = FakeClient("normal", codes=(Code.WRONG_PARAMETER,))
    with pytest.raises(surefoot.Error, match="RELEASE_MODE: got code 7001"):
        switcher(monkeypatch, client).release(lambda _: None, **TIMES)


@pytest.mark.parametrize("code", [Code.OK, Code.BUSY, Code.TIMEOUT])
def test_select_waits_until_the_mode_is_active(code: int, monkeypatch: pytest.MonkeyPatch) -> None:
    client = FakeClient("", codes=(code,), checks=3)
    switcher(monkeypatch, client).select_mode("normal", **TIMES)
    assert client.mode == "normal"
    assert client.calls.count(Api.SELECT_MODE) == (2 if code == Code.BUSY else 1)


def test_select_of_a_mode_that_does_not_begin_is_an_error_with_a_remedy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    client = FakeClient("", codes=(Code.TIMEOUT,), checks=10**6)
    with pytest.raises(surefoot.Error, match=r"got no mode 0.05 s after.*vendor's app"):
        switcher(monkeypatch, client).select_mode("normal", **TIMES)
