package org.robonewbie.competition.contest;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/** What is different between the matches of a course and those of a league. */
public enum MatchKind {
    /** Small teams on the small pitch without fouls; two teams meet once. */
    MATCHES("matches", "Matches", "Every team plays every other team once"),
    /** Whole teams on the league's pitch under the league's rules; two teams meet twice, the second time with changed sides. */
    LEAGUE("league", "League", "Every team plays every other team twice, home and away,");

    /** So much longer than a match is its half, so that the contest and not the referee ends it. */
    private static final double SPARE_SECONDS = 60;

    private static final double MOST_PLAYERS = 11;

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

    /** Who meets whom, as the beginning of a sentence. */
    String pairing() {
        return pairing;
    }

    /** Pitch and rules of a match that lasts as long as is said. */
    SoccerParameters parameters(double seconds) {
        return this == LEAGUE ? league(seconds) : beginners();
    }

    /** Whether robots begin where their programs have beamed them. */
    boolean hasOwnPlaces() {
        return this == LEAGUE;
    }

    /** Who has the first kick-off: in a league the team at home, else each side in turn. */
    TeamSide kickOff(Fixture.Pair pair) {
        return this == LEAGUE || pair.number() % 2 == 0 ? TeamSide.LEFT : TeamSide.RIGHT;
    }

    /** All meetings, in their order. */
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

    /** The league's rules, but robots may all be of one type, so that every program can take part. */
    private static SoccerParameters league(double seconds) {
        return SoccerParameters.league()
                .with(SoccerParameter.SINGLE_HALF_TIME, 1)
                .with(SoccerParameter.RULE_HALF_TIME, seconds + SPARE_SECONDS)
                .with(SoccerParameter.MAX_ROBOT_TYPE_COUNT, MOST_PLAYERS)
                .with(SoccerParameter.MIN_ROBOT_TYPES_COUNT, 1)
                .with(SoccerParameter.MAX_SUM_TWO_ROBOT_TYPES, MOST_PLAYERS);
    }
}
