package org.robonewbie.competition.contest;

import java.util.List;

/**
 * A team's part in a trial.
 *
 * @param team name of the team
 * @param role what its program has to be
 * @param places where its robots start; as many robots may it have
 */
public record Entrant(String team, Role role, List<StartPlace> places) {

    /** Makes the list unmodifiable. */
    public Entrant {
        places = List.copyOf(places);
    }

    /**
     * Enters a team with one robot.
     *
     * @param team name of the team
     * @param role what its program has to be
     * @param place where its robot starts
     * @return its part
     */
    public static Entrant of(String team, Role role, StartPlace place) {
        return new Entrant(team, role, List.of(place));
    }
}
