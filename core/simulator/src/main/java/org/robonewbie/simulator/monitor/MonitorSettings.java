package org.robonewbie.simulator.monitor;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.protocol.monitor.Environment;

/**
 * Where monitors connect and what they receive about the world besides its state.
 *
 * @param bindAddress address of this computer at which to listen, such as 127.0.0.1
 * @param port the TCP port, or 0 for any free one
 * @param stepSeconds time between two messages; rounded to whole cycles of 0.02 s
 * @param environment what stays constant during the match
 * @param field the pitch
 * @param ballRadius of the ball in metres
 */
public record MonitorSettings(
        String bindAddress,
        int port,
        double stepSeconds,
        Environment environment,
        SoccerField field,
        double ballRadius) {

    /** Time between two messages of rcssserver3d. */
    public static final double STANDARD_STEP_SECONDS = 0.04;

    int cyclesPerMessage() {
        return (int) Math.max(1, PortableMath.round(stepSeconds / Cycle.SECONDS));
    }
}
