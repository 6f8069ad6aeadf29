"""Reference controllers, to compare with: plain joint PD, and balance by forces alone."""

from surefoot.assess.references.pd import JointPd

REFERENCES = {"pd": JointPd}

__all__ = ["REFERENCES", "JointPd"]
