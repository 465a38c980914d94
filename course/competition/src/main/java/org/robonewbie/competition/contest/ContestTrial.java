package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * Complete specification of one trial of a contest.
 *
 * @param id name, unique in the contest; consists of letters, digits and hyphens, because files are named after it
 * @param seed seed of all random numbers
 * @param parameters pitch and rules
 * @param entrants participating teams
 * @param seconds time limit in simulated seconds
 * @param kickOff side that takes the first kick-off
 * @param ball position of the ball in the coordinates of the first entrant, in metres; empty for the centre spot
 * @param ownPlaces whether robots start where their programs beam them, instead of at the entrants' start poses
 */
public record ContestTrial(
        String id,
        long seed,
        SoccerParameters parameters,
        List<Entrant> entrants,
        double seconds,
        TeamSide kickOff,
        Optional<Vector3> ball,
        boolean ownPlaces) {

    /** Creates the trial. */
    public ContestTrial {
        entrants = List.copyOf(entrants);
    }

    /** {@return the number of robots of all teams} */
    public int robots() {
        return entrants.stream().mapToInt(entrant -> entrant.places().size()).sum();
    }

    /**
     * Creates a trial with a single team on the pitch.
     *
     * @param id name of the trial
     * @param seed seed of all random numbers
     * @param entrant the team
     * @param seconds time limit in simulated seconds
     * @return the trial
     */
    static ContestTrial alone(String id, long seed, Entrant entrant, double seconds) {
        return new ContestTrial(
                id,
                seed,
                SoccerParameters.beginner(),
                List.of(entrant),
                seconds,
                TeamSide.LEFT,
                Optional.empty(),
                false);
    }
}
