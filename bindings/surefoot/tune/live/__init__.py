"""Page of surefoot tune live: a standing robot, and controls for its gains, in a browser."""
