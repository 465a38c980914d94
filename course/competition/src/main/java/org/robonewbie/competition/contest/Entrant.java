package org.robonewbie.competition.contest;

import java.util.List;

/**
 * Participation of a team in a trial.
 *
 * @param team name of the team
 * @param role role of its program
 * @param places start poses of its robots, one per robot
 */
public record Entrant(String team, Role role, List<StartPlace> places) {

    /** Creates the participation. */
    public Entrant {
        places = List.copyOf(places);
    }

    /**
     * Creates the participation of a team with one robot.
     *
     * @param team name of the team
     * @param role role of its program
     * @param place start pose of its robot
     * @return the participation
     */
    public static Entrant of(String team, Role role, StartPlace place) {
        return new Entrant(team, role, List.of(place));
    }
}
