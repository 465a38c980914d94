package org.robonewbie.competition.contest;

import java.util.List;

/**
 * A team that takes part in a trial.
 *
 * @param team name of the team
 * @param role role of its program
 * @param places start poses, one per robot
 */
public record Entrant(String team, Role role, List<StartPlace> places) {

    /** Stores an unmodifiable copy of the list of start poses. */
    public Entrant {
        places = List.copyOf(places);
    }

    /**
     * Creates an entrant with one robot.
     *
     * @param team name of the team
     * @param role role of its program
     * @param place start pose of its robot
     * @return the entrant
     */
    public static Entrant of(String team, Role role, StartPlace place) {
        return new Entrant(team, role, List.of(place));
    }
}
