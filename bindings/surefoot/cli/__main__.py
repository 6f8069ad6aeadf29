"""python -m surefoot.cli is the command surefoot."""

import sys

from surefoot.cli import main

if __name__ == "__main__":  # a process that Python starts beside it imports this file as well
    sys.exit(main())
