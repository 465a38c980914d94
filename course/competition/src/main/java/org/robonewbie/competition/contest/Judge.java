package org.robonewbie.competition.contest;

import java.util.Map;
import org.robonewbie.simulator.WorldSnapshot;

/** Scores one trial by observing the world in each cycle. */
public interface Judge {

    /** Name under which a team's goals are reported. */
    String GOALS = "goals";

    /**
     * Evaluates the world after a cycle.
     *
     * @param world current state of the world
     * @return whether the trial is decided
     */
    boolean watch(WorldSnapshot world);

    /**
     * Returns the values measured for a team so far.
     *
     * @param team name of the team
     * @return measured values by name
     */
    Map<String, Double> figures(String team);

    /**
     * Returns whether a team is on the pitch.
     *
     * @param world current state of the world
     * @param team name of the team
     * @return whether the team has a robot on the pitch
     */
    static boolean isPresent(WorldSnapshot world, String team) {
        return world.robots().stream().anyMatch(robot -> robot.team().equals(team));
    }

    /**
     * Returns the number of goals that a team on the pitch has scored.
     *
     * @param world current state of the world
     * @param team name of the team
     * @return the number of goals
     */
    static int goals(WorldSnapshot world, String team) {
        return world.teamLeft().equals(team) ? world.scoreLeft() : world.scoreRight();
    }
}
