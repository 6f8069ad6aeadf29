"""All checks of surefoot doctor, and their text."""

from __future__ import annotations

from surefoot.doctor import installation, network, real_time, simulation
from surefoot.doctor.finding import Finding, Verdict

AREAS = (installation.AREA, real_time.AREA, network.AREA, simulation.AREA)
_MARKS = {Verdict.GOOD: "ok", Verdict.LIMITED: "!!", Verdict.BAD: "BAD", Verdict.INFO: ""}


def diagnose(timer_seconds: float = 2.0) -> list[Finding]:
    """Run all checks; this takes some seconds.

    Args:
        timer_seconds: Time for which the timer is measured [s].
    """
    return [
        *installation.check_installation(),
        *real_time.check_real_time(timer_seconds),
        *network.check_network(),
        *simulation.check_simulation(),
    ]


def findings_text(findings: list[Finding]) -> str:
    """Return the findings as text, by area, each remedy below its finding."""
    width = max(len(finding.subject) for finding in findings)
    lines = []
    for area in AREAS:
        lines.append(f"{area}:")
        for finding in findings:
            if finding.area != area:
                continue
            mark = _MARKS[finding.verdict]
            lines.append(f"  {mark:3} {finding.subject:{width}}  {finding.value}".rstrip())
            if finding.remedy:
                lines.append(f"      {'':{width}}  -> {finding.remedy}")
    return "\n".join(lines)
