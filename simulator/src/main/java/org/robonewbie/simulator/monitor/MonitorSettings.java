package org.robonewbie.simulator.monitor;

import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.monitor.Environment;

/**
 * Where monitors connect and what they are told of the world beyond its state.
 *
 * @param bindAddress address of this computer at which to listen, such as 127.0.0.1
 * @param port the TCP port, or 0 for any free one
 * @param stepSeconds time between two messages; rounded to whole cycles of 0.02 s
 * @param environment what does not change during the match
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

    private static final double CYCLE_SECONDS = 0.02;

    int cyclesPerMessage() {
        return (int) Math.max(1, Math.round(stepSeconds / CYCLE_SECONDS));
    }
}
