package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

/**
 * The state of the game as reported by the referee: perceptor {@code GS}.
 *
 * @param number the robot's shirt number; sent once, after the robot has joined its team
 * @param side the side of the robot's team; sent once, together with the number
 * @param leftScore goals of the left team; not sent by older servers
 * @param rightScore goals of the right team; not sent by older servers
 * @param playSeconds game time in seconds, which does not advance before the kick-off or after the game
 * @param playModeName SimSpark's name for the play mode, which may be unknown to this framework
 */
public record GameState(
        OptionalInt number,
        Optional<TeamSide> side,
        OptionalInt leftScore,
        OptionalInt rightScore,
        double playSeconds,
        String playModeName) {

    /** {@return the play mode; empty if its name is unknown} */
    public Optional<PlayMode> playMode() {
        return PlayMode.ofSimSparkName(playModeName);
    }
}
