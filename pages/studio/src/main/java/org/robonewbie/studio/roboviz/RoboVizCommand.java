package org.robonewbie.studio.roboviz;

import java.util.List;
import org.robonewbie.nao.TeamSide;

/** One command of RoboViz's drawing protocol. Places are metres in the world frame, z up. */
sealed interface RoboVizCommand {

    /**
     * Shows what was drawn since the last swap.
     *
     * @param prefix the sets whose names begin with it; empty for all
     */
    record Swap(String prefix) implements RoboVizCommand {}

    /**
     * Draws into the hidden buffer of a set.
     *
     * @param set name of the set, such as {@code Stars.3.path}
     * @param shape {@code circle}, {@code line}, {@code point}, {@code sphere}, {@code polygon} or {@code text}
     * @param numbers places and sizes, in the protocol's order
     * @param colour such as {@code #ff8800}
     * @param opacity from 0 to 1
     * @param text what is written; empty for other shapes
     */
    record Draw(String set, String shape, List<Double> numbers, String colour, double opacity, String text)
            implements RoboVizCommand {}

    /**
     * Writes above a robot, at once.
     *
     * @param side its team
     * @param number its number
     * @param colour such as {@code #ff8800}
     * @param text what is written; empty takes it away
     */
    record AgentText(TeamSide side, int number, String colour, String text) implements RoboVizCommand {}

    /** A command that changes nothing in the picture of the studio, such as the selection of a robot. */
    record Other() implements RoboVizCommand {}
}
