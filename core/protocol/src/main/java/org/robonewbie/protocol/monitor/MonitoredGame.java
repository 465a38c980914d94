package org.robonewbie.protocol.monitor;

import java.util.Optional;
import org.robonewbie.nao.PlayMode;

/**
 * The state of the match in monitor messages.
 *
 * @param timeSeconds game time in seconds
 * @param teamLeft name of the left team; empty before it joins
 * @param teamRight name of the right team; empty before it joins
 * @param half the half, 1 or 2
 * @param scoreLeft goals of the left team
 * @param scoreRight goals of the right team
 * @param playMode the play mode; empty before the first message, and if a newer server sends an unknown play mode
 * @param passWaitLeftSeconds time in seconds until the left team may score after its pass mode; 0 if it may score
 * @param passWaitRightSeconds time in seconds until the right team may score after its pass mode; 0 if it may score
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

    /** The state before the first message. */
    public static final MonitoredGame UNKNOWN =
            new MonitoredGame(0, Optional.empty(), Optional.empty(), 1, 0, 0, Optional.empty(), 0, 0);
}
