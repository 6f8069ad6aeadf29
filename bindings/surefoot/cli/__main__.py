"""Entry point of python -m surefoot.cli, which is the command surefoot."""

import sys

from surefoot.cli import main

if __name__ == "__main__":  # worker processes import this file too
    sys.exit(main())
