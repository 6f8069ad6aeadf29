"""Comparison with TSID and PlaCo: interleaved ticks on the same robot, tasks and motion."""

from surefoot.bench.peers.comparison_text import peers_text
from surefoot.bench.peers.options import PeerError, PeerOptions
from surefoot.bench.peers.result_rows import RATIOS
from surefoot.bench.peers.run import add_peers, run_peers

__all__ = ["RATIOS", "PeerError", "PeerOptions", "add_peers", "peers_text", "run_peers"]
