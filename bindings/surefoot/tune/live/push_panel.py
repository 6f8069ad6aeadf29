"""Panel that pushes the shown robot, or compares the costs of one push for the gains A and B."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import viser

from surefoot._core import Error
from surefoot.tune.cost import Cost
from surefoot.tune.live.gain_editor import SLOTS
from surefoot.tune.live.notifier import Notifier
from surefoot.tune.live.push_cost import push_cost
from surefoot.tune.live.simulation import Simulation

_DIRECTION_MARKS = ((-180, "back"), (-90, "right"), (0, "ahead"), (90, "left"), (180, ""))


class PushPanel:
    """Panel that pushes the simulated robot and shows the cost.

    Args:
        gui: GUI that gets the panel.
        simulation: The simulated robot.
        post: Function that runs an action in the thread that owns the simulation.
        notifier: Notifier that shows errors.
    """

    def __init__(
        self,
        gui: viser.GuiApi,
        simulation: Simulation,
        post: Callable[[Callable[[], Any]], None],
        notifier: Notifier,
    ) -> None:
        self._simulation, self._post, self._notifier = simulation, post, notifier
        self._impulse, self._comparison = "", ""
        hint = "0: forward, 90: to the left"
        self._direction = gui.add_slider(
            "direction [deg]", -180.0, 180.0, 5.0, 90.0, marks=_DIRECTION_MARKS, hint=hint
        )
        hint = "impulse in percent of the LIP push limit, computed for the present foot positions"
        self._strength = gui.add_slider("strength [%]", 0.0, 150.0, 5.0, 50.0, hint=hint)
        push = gui.add_button("Push", color="red", icon=viser.Icon.HAND_STOP)
        push.on_click(lambda _: post(self._push))
        compare = gui.add_button(
            "Compare A and B",
            hint="simulate this push twice, with the gains A and with the gains B",
        )
        compare.on_click(lambda _: self._compare())
        self._text = gui.add_markdown("")

    def refresh(self) -> None:
        """Show the cost of the last push."""
        score, lines = self._simulation.score, [self._impulse]
        if score.seconds_left > 0.0:
            lines.append(f"The cost is ready in {score.seconds_left:.0f} s.")
        elif score.last_cost is not None:
            lines.append(
                f"**Cost {score.last_cost.value:.2f}** (lower is better): {_terms(score.last_cost)}"
            )
        text = "\n\n".join(line for line in (*lines, self._comparison) if line)
        if text != self._text.content:
            self._text.content = text

    def _push(self) -> None:
        impulse = self._simulation.push(self._direction.value, self._strength.value)
        self._impulse = f"Last push: {impulse:.1f} N.s in 0.1 s."

    def _compare(self) -> None:
        simulation, slots = self._simulation, self._simulation.editor.slots
        missing = [slot for slot in SLOTS if slot not in slots]
        if missing:
            self._notifier.show_error(f"no gains are stored as {' and '.join(missing)} yet")
            return
        push = self._direction.value, self._strength.value
        self._comparison = "Comparing A and B ..."
        try:
            costs = {
                slot: push_cost(simulation.description, simulation.world, slots[slot], *push)
                for slot in SLOTS
            }
        except Error as problem:
            self._comparison = ""
            self._notifier.show_error(str(problem))
            return
        self._comparison = comparison_text(costs)


def comparison_text(costs: dict[str, Cost]) -> str:
    """Return the costs and their terms as a Markdown table, one column per set of gains."""
    names = next(iter(costs.values())).terms
    rows = [("cost", [cost.value for cost in costs.values()])]
    rows += [(name, [cost.terms[name] for cost in costs.values()]) for name in names]
    lines = [f"| | {' | '.join(costs)} |", "|---" * (1 + len(costs)) + "|"]
    lines += [f"| {name} | {' | '.join(f'{v:.2f}' for v in values)} |" for name, values in rows]
    return "\n".join(lines)


def _terms(cost: Cost) -> str:
    return ", ".join(f"{name} {value:.2f}" for name, value in cost.terms.items() if value > 0.0)
