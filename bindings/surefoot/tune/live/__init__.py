"""Page of surefoot tune live: a robot that stands and walks, with controls, in a browser."""
