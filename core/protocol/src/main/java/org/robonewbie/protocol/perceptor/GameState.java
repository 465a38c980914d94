package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import java.util.OptionalInt;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;

/**
 * The state of the game as reported by the referee: perceptor {@code GS}.
 *
 * @param number the robot's own shirt number; sent once, after the robot has joined its team
 * @param side the side of the robot's own team; sent once, together with the number
 * @param leftScore goals of the left team; older servers do not send it
 * @param rightScore goals of the right team; older servers do not send it
 * @param playSeconds game time in seconds; stopped before the kick-off and after the game
 * @param playModeName the play mode in SimSpark's spelling, also of a newer server whose play modes are not known here
 */
public record GameState(
        OptionalInt number,
        Optional<TeamSide> side,
        OptionalInt leftScore,
        OptionalInt rightScore,
        double playSeconds,
        String playModeName) {

    /** {@return the play mode; empty if its name is not known here} */
    public Optional<PlayMode> playMode() {
        return PlayMode.ofSimSparkName(playModeName);
    }
}
