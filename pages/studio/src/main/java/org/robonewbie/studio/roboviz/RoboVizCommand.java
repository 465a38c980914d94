package org.robonewbie.studio.roboviz;

import java.util.List;
import org.robonewbie.nao.TeamSide;

/** One command of RoboViz's drawing protocol. Positions are in metres in the world frame, z up. */
sealed interface RoboVizCommand {

    /**
     * Swaps the buffers of drawing sets.
     *
     * @param prefix prefix of the names of the sets; empty for all sets
     */
    record Swap(String prefix) implements RoboVizCommand {}

    /**
     * Draws into the back buffer of a set.
     *
     * @param set name of the set, such as {@code Stars.3.path}
     * @param shape {@code circle}, {@code line}, {@code point}, {@code sphere}, {@code polygon} or {@code text}
     * @param numbers positions and sizes, in the protocol's order
     * @param colour colour such as {@code #ff8800}
     * @param opacity opacity, from 0 to 1
     * @param text the text; empty for other shapes
     */
    record Draw(String set, String shape, List<Double> numbers, String colour, double opacity, String text)
            implements RoboVizCommand {}

    /**
     * Shows text above a robot, without buffering.
     *
     * @param side team of the robot
     * @param number player number of the robot
     * @param colour colour such as {@code #ff8800}
     * @param text the text; empty removes it
     */
    record AgentText(TeamSide side, int number, String colour, String text) implements RoboVizCommand {}

    /** A command that has no effect in the studio, such as the selection of a robot. */
    record Other() implements RoboVizCommand {}
}
