package org.robonewbie.competition.contest;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * One trial of a contest, fixed to the last detail before it begins.
 *
 * @param id its name, unique in its contest; letters, digits and hyphens, so that files can be named after it
 * @param seed start of all random numbers
 * @param parameters pitch and rules
 * @param entrants who takes part
 * @param seconds simulated seconds that it lasts at most
 * @param kickOff the side that kicks off
 * @param ball where the ball lies, as the first entrant sees the pitch, metres; empty for the centre spot
 * @param ownPlaces whether robots begin where their programs have beamed them, instead of at the places of their entrants
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

    /** Makes the list unmodifiable. */
    public ContestTrial {
        entrants = List.copyOf(entrants);
    }

    /** {@return the number of robots of all teams} */
    public int robots() {
        return entrants.stream().mapToInt(entrant -> entrant.places().size()).sum();
    }

    /**
     * Plans a trial of one team that is alone on the pitch.
     *
     * @param id its name
     * @param seed start of all random numbers
     * @param entrant who takes part
     * @param seconds simulated seconds that it lasts at most
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
