package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** Kinds of matches: course matches and league matches. */
public enum MatchKind {
    /** Small teams on the small pitch without fouls; single round robin. */
    MATCHES("matches", "Matches", "Each team plays every other team once, by the beginner's rules,"),
    /** Full teams on the league's pitch under the league's rules; double round robin with swapped sides. */
    LEAGUE("league", "League", "Each team plays every other team twice, home and away, by the league's rules,");

    /** Seconds by which the simulated half is longer than the match, so that it is the contest, not the referee, that ends the match. */
    private static final double SPARE_SECONDS = 60;

    private static final double MAX_PLAYERS = 11;

    private final String word;
    private final String title;
    private final String pairing;

    MatchKind(String word, String title, String pairing) {
        this.word = word;
        this.title = title;
        this.pairing = pairing;
    }

    /** {@return the contest's name on the command line} */
    public String word() {
        return word;
    }

    String title() {
        return title;
    }

    /** Returns the beginning of a sentence that describes the pairings. */
    String pairing() {
        return pairing;
    }

    /** Returns the pitch and rules for a match of the given length. */
    SoccerParameters parameters(double seconds) {
        return this == LEAGUE ? league(seconds) : beginners();
    }

    /** Returns whether robots start where their programs beam them. */
    boolean hasOwnPlaces() {
        return this == LEAGUE;
    }

    /** Returns the side that takes the first kick-off: the home team's side in a league, alternating sides otherwise. */
    TeamSide kickOff(Fixture.Pair pair) {
        return this == LEAGUE || pair.number() % 2 == 0 ? TeamSide.LEFT : TeamSide.RIGHT;
    }

    List<Fixture.Pair> pairs(List<String> teams) {
        List<Fixture.Pair> once = Fixture.pairs(teams);
        if (this != LEAGUE) {
            return once;
        }
        List<Fixture.Pair> twice = new ArrayList<>(once);
        once.forEach(pair -> twice.add(pair.again(twice.size() + 1)));
        return List.copyOf(twice);
    }

    private static SoccerParameters beginners() {
        return SoccerParameters.beginner()
                .with(SoccerParameter.AUTOMATIC_KICK_OFF, 0)
                .with(SoccerParameter.START_ANY_FIELD_POSITION, 0)
                .with(SoccerParameter.BEAM_GRACE_TIME, 0);
    }

    /** Returns the league rules without the limits on robot types, so that any program can take part. */
    private static SoccerParameters league(double seconds) {
        return SoccerParameters.league()
                .with(SoccerParameter.SINGLE_HALF_TIME, 1)
                .with(SoccerParameter.RULE_HALF_TIME, seconds + SPARE_SECONDS)
                .with(SoccerParameter.MAX_ROBOT_TYPE_COUNT, MAX_PLAYERS)
                .with(SoccerParameter.MIN_ROBOT_TYPES_COUNT, 1)
                .with(SoccerParameter.MAX_SUM_TWO_ROBOT_TYPES, MAX_PLAYERS);
    }
}
