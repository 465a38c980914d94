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
 */
public record ContestTrial(
        String id,
        long seed,
        SoccerParameters parameters,
        List<Entrant> entrants,
        double seconds,
        TeamSide kickOff,
        Optional<Vector3> ball) {

    /** Makes the list unmodifiable. */
    public ContestTrial {
        entrants = List.copyOf(entrants);
    }

    /** {@return the number of robots of all teams} */
    public int robots() {
        return entrants.stream().mapToInt(entrant -> entrant.places().size()).sum();
    }

    /** {@return whether a team is alone on the pitch} */
    public boolean isSolo() {
        return entrants.size() == 1;
    }
}
