"""Checks of the network interfaces."""

from __future__ import annotations

import socket
from pathlib import Path

from surefoot.doctor.finding import Finding, Verdict

AREA = "network"
_UP, _MULTICAST, _LOOPBACK = 0x1, 0x1000, 0x8  # IFF_ flags of <net/if.h>
_NET = Path("/sys/class/net")


def check_network() -> list[Finding]:
    """Check each interface: whether it is up, and whether DDS can use multicast on it."""
    names = [name for _, name in socket.if_nameindex()]
    return [check_interface(name, interface_flags(name)) for name in names]


def interface_flags(name: str) -> int | None:
    """Return the IFF_ flags of an interface; None if the system does not tell."""
    try:
        return int((_NET / name / "flags").read_text(encoding="utf-8"), 16)
    except (OSError, ValueError):
        return None


def check_interface(name: str, flags: int | None) -> Finding:
    """Judge an interface.

    Args:
        name: Name of the interface.
        flags: Its IFF_ flags; None: unknown.
    """
    subject = f"interface {name}"
    if flags is None:
        return Finding(AREA, subject, "unknown state", Verdict.INFO)
    if not flags & _UP:
        return Finding(AREA, subject, "down", Verdict.INFO)
    if flags & _MULTICAST:
        return Finding(AREA, subject, "up, multicast", Verdict.GOOD)
    if flags & _LOOPBACK:  # DDS programs on one computer find each other without it
        return Finding(AREA, subject, "up, no multicast", Verdict.INFO)
    remedy = f"a robot over DDS needs it: sudo ip link set {name} multicast on"
    return Finding(AREA, subject, "up, no multicast", Verdict.LIMITED, remedy)
