"""The live page: a robot that stands, in a browser, and everything that tunes it beside it."""
