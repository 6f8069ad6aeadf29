"""surefoot doctor: checks the installation and the computer."""

from __future__ import annotations

import argparse

from surefoot.cli.output_files import check_json_path, write_json
from surefoot.doctor import Verdict, diagnose, findings_text

# Exit status if a check is BAD, as of other commands whose result is bad.
_BAD_STATUS = 3


def add_doctor_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of surefoot doctor."""
    parser.add_argument("--json", metavar="FILE|-", help="write the findings; - is stdout")
    parser.epilog = "exit status: 0, or 3 if a check is BAD: Surefoot then does not work"


def doctor(arguments: argparse.Namespace) -> int:
    """Check everything and print it; return 3 if a check is BAD."""
    check_json_path(arguments.json)
    findings = diagnose()
    if arguments.json != "-":
        print(findings_text(findings))
    result = {
        "findings": [
            {
                "area": finding.area,
                "subject": finding.subject,
                "value": finding.value,
                "verdict": finding.verdict.value,
                "remedy": finding.remedy,
            }
            for finding in findings
        ]
    }
    write_json(arguments.json, result)
    return _BAD_STATUS if any(finding.verdict == Verdict.BAD for finding in findings) else 0
