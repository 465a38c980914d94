package org.robonewbie.studio.monitor;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.monitor.Environment;
import org.robonewbie.simulator.PitchDetails;

/**
 * The pitch of an RCSSServerMJ. Measures that the server does not send default to its pitch for 7 against 7.
 *
 * <p>rcsssmj 0.2.1 exchanges {@code GoalWidth} and {@code GoalDepth}. A goal is always wider than deep, so the larger one is the width.
 */
final class RsmpPitch {

    private RsmpPitch() {}

    static SoccerField field(Environment environment) {
        double one = environment.measure("GoalWidth").orElse(3.66);
        double other = environment.measure("GoalDepth").orElse(1);
        double goalWidth = Math.max(one, other);
        double areaLength = environment.measure("GoalieAreaLength").orElse(4);
        double areaWidth = environment.measure("GoalieAreaWidth").orElse(7.3);
        return new SoccerField(
                environment.measure("FieldLength").orElse(55),
                environment.measure("FieldWidth").orElse(36),
                goalWidth,
                Math.min(one, other),
                environment.measure("GoalHeight").orElse(1.83),
                environment.measure("PenaltyAreaLength").orElse(areaLength),
                Math.max(0, environment.measure("PenaltyAreaWidth").orElse(areaWidth) - goalWidth),
                environment.measure("CenterCircleRadius").orElse(5.5));
    }

    static PitchDetails details(Environment environment) {
        return new PitchDetails(
                environment.measure("BallRadius").orElse(0.11),
                environment.measure("GoalieAreaLength").orElse(4),
                environment.measure("GoalieAreaWidth").orElse(7.3),
                environment.measure("PenaltySpotDistance").orElse(7.32));
    }
}
