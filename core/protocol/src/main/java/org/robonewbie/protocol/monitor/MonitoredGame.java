package org.robonewbie.protocol.monitor;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;

/**
 * The state of the match as monitors show it.
 *
 * @param timeSeconds game time
 * @param teamLeft name of the left team, empty before it joined
 * @param teamRight name of the right team, empty before it joined
 * @param half 1 or 2
 * @param scoreLeft goals of the left team
 * @param scoreRight goals of the right team
 * @param playMode the play mode; empty before it is known, and for a play mode of a newer server
 * @param passWaitLeftSeconds how long the left team still must not score after its pass mode; 0 if it may
 * @param passWaitRightSeconds the same for the right team
 */
public record MonitoredGame(
        double timeSeconds,
        Optional<String> teamLeft,
        Optional<String> teamRight,
        int half,
        int scoreLeft,
        int scoreRight,
        Optional<PlayMode> playMode,
        double passWaitLeftSeconds,
        double passWaitRightSeconds) {

    /** The state before any was received. */
    public static final MonitoredGame UNKNOWN =
            new MonitoredGame(0, Optional.empty(), Optional.empty(), 1, 0, 0, Optional.empty(), 0, 0);
}
