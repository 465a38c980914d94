package org.robonewbie.simulator.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.monitor.Environment;
import org.robonewbie.protocol.monitor.Environment.Measure;
import org.robonewbie.simulator.soccer.SoccerParameter;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The environment message, which describes the pitch and the rules to monitors in the same order as rcssserver3d 0.7.3.
 */
final class MatchEnvironment {

    private static final List<SoccerParameter> REPORTED = List.of(
            SoccerParameter.FIELD_LENGTH,
            SoccerParameter.FIELD_WIDTH,
            SoccerParameter.FIELD_HEIGHT,
            SoccerParameter.GOAL_WIDTH,
            SoccerParameter.GOAL_DEPTH,
            SoccerParameter.GOAL_HEIGHT,
            SoccerParameter.BORDER_SIZE,
            SoccerParameter.FREE_KICK_DISTANCE,
            SoccerParameter.WAIT_BEFORE_KICK_OFF,
            SoccerParameter.AGENT_RADIUS,
            SoccerParameter.BALL_RADIUS,
            SoccerParameter.BALL_MASS,
            SoccerParameter.RULE_GOAL_PAUSE_TIME,
            SoccerParameter.RULE_KICK_IN_PAUSE_TIME,
            SoccerParameter.RULE_HALF_TIME,
            SoccerParameter.PASS_MODE_MIN_OPPONENT_BALL_DISTANCE,
            SoccerParameter.PASS_MODE_DURATION);

    private MatchEnvironment() {}

    static Environment of(SoccerParameters parameters) {
        List<Measure> measures = new ArrayList<>();
        for (SoccerParameter parameter : REPORTED) {
            measures.add(new Measure(parameter.simSparkName(), parameters.get(parameter)));
        }
        addPenaltyArea(parameters.field(), measures);
        return new Environment(
                measures,
                PlayMode.simSparkModes().stream().map(PlayMode::simSparkName).toList());
    }

    /** Adds the penalty area if it differs from the league's, which monitors draw by default. */
    private static void addPenaltyArea(SoccerField field, List<Measure> measures) {
        double width = field.penaltyWidth() + field.goalWidth();
        double leagueWidth = SoccerField.LEAGUE.penaltyWidth() + SoccerField.LEAGUE.goalWidth();
        if (field.penaltyLength() != SoccerField.LEAGUE.penaltyLength() || width != leagueWidth) {
            measures.add(new Measure("GoalieAreaLength", field.penaltyLength()));
            measures.add(new Measure("GoalieAreaWidth", width));
        }
    }
}
