package org.robonewbie.simulator.monitor;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.simulator.soccer.SoccerParameters;

/**
 * The configuration of a monitor port.
 *
 * @param bindAddress local address to listen on, such as 127.0.0.1
 * @param port TCP port, 0 for any free port
 * @param stepSeconds simulated seconds between messages, rounded to whole cycles of 0.02 s
 * @param parameters pitch and rules
 */
public record MonitorSettings(String bindAddress, int port, double stepSeconds, SoccerParameters parameters) {

    /** Seconds between messages in rcssserver3d. */
    public static final double DEFAULT_STEP_SECONDS = 0.04;

    int cyclesPerMessage() {
        return (int) Math.max(1, PortableMath.round(stepSeconds / Cycle.SECONDS));
    }
}
