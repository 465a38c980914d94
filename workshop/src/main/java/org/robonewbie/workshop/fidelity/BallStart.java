package org.robonewbie.workshop.fidelity;

import java.io.IOException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robonewbie.nao.Vector3;

/**
 * Initial state of a ball, parsed from the name of the recorded case: {@code roll_v3} rolls at 3 m/s along x,
 * {@code drop_h0.5} falls from 0.5 m, {@code lob_4_4} flies at 4 m/s along x and 4 m/s upward. Any suffix, such as
 * {@code _beforekickoff}, is ignored.
 *
 * @param position centre of the ball in metres
 * @param velocity velocity in m/s
 */
record BallStart(Vector3 position, Vector3 velocity) {

    private static final String NUMBER = "(-?\\d+(?:\\.\\d+)?)";
    private static final String END = "(?![\\d.]).*";
    private static final Pattern ROLL = Pattern.compile("roll_v?" + NUMBER + END);
    private static final Pattern DROP = Pattern.compile("drop_h?" + NUMBER + END);
    private static final Pattern LOB = Pattern.compile("lob_v?" + NUMBER + "_" + NUMBER + END);

    static BallStart of(String caseName, double ballRadius) throws IOException {
        Vector3 onTheGround = new Vector3(0, 0, ballRadius);
        Matcher roll = ROLL.matcher(caseName);
        if (roll.matches()) {
            return new BallStart(onTheGround, new Vector3(number(roll, 1), 0, 0));
        }
        Matcher drop = DROP.matcher(caseName);
        if (drop.matches()) {
            return new BallStart(new Vector3(0, 0, number(drop, 1)), Vector3.ZERO);
        }
        Matcher lob = LOB.matcher(caseName);
        if (lob.matches()) {
            return new BallStart(onTheGround, new Vector3(number(lob, 1), 0, number(lob, 2)));
        }
        throw new IOException(
                "Unknown ball case \"" + caseName + "\". Expected a name such as roll_v3, drop_h0.5 or lob_4_4.");
    }

    private static double number(Matcher matcher, int group) {
        return Double.parseDouble(matcher.group(group));
    }
}
