package org.robonewbie.competition.contest;

import java.util.Map;
import org.robonewbie.simulator.SimulationControl;

/** Watches one trial, cycle by cycle, and measures. */
public interface Judge {

    /**
     * Looks at the world after a cycle.
     *
     * @param moment what is true now
     * @param referee steers the world, for contests in which something happens to the robots
     * @return whether the trial is decided
     */
    boolean watch(JudgedMoment moment, SimulationControl referee);

    /**
     * Returns what a team has reached so far.
     *
     * @param team name of the team
     * @return figures by name
     */
    Map<String, Double> figures(String team);
}
