package org.robonewbie.nao;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** What the referee has decided: the state of the game, in the order and with the names of SimSpark 0.7.3. */
public enum PlayMode {
    /** Nobody may play yet; robots may be beamed. */
    BEFORE_KICK_OFF("BeforeKickOff"),
    /** The left team begins. */
    KICK_OFF_LEFT("KickOff_Left"),
    /** The right team begins. */
    KICK_OFF_RIGHT("KickOff_Right"),
    /** The game runs. */
    PLAY_ON("PlayOn"),
    /** The ball left the field at the side; the left team brings it back. */
    KICK_IN_LEFT("KickIn_Left"),
    /** The ball left the field at the side; the right team brings it back. */
    KICK_IN_RIGHT("KickIn_Right"),
    /** The left team plays from the corner. */
    CORNER_KICK_LEFT("corner_kick_left"),
    /** The right team plays from the corner. */
    CORNER_KICK_RIGHT("corner_kick_right"),
    /** The left team plays from its goal area. */
    GOAL_KICK_LEFT("goal_kick_left"),
    /** The right team plays from its goal area. */
    GOAL_KICK_RIGHT("goal_kick_right"),
    /** Offside of the left team; the rule is switched off in the original. */
    OFFSIDE_LEFT("offside_left"),
    /** Offside of the right team; the rule is switched off in the original. */
    OFFSIDE_RIGHT("offside_right"),
    /** The game is over. */
    GAME_OVER("GameOver"),
    /** The left team has scored; robots may be beamed. */
    GOAL_LEFT("Goal_Left"),
    /** The right team has scored; robots may be beamed. */
    GOAL_RIGHT("Goal_Right"),
    /** An indirect free kick of the left team. */
    FREE_KICK_LEFT("free_kick_left"),
    /** An indirect free kick of the right team. */
    FREE_KICK_RIGHT("free_kick_right"),
    /** A direct free kick of the left team. */
    DIRECT_FREE_KICK_LEFT("direct_free_kick_left"),
    /** A direct free kick of the right team. */
    DIRECT_FREE_KICK_RIGHT("direct_free_kick_right"),
    /** The left team passes undisturbed. */
    PASS_LEFT("pass_left"),
    /** The right team passes undisturbed. */
    PASS_RIGHT("pass_right");

    /** The answers of {@link #ofSimSparkName}, which is asked in each cycle and shall make no garbage. */
    private static final Map<String, Optional<PlayMode>> BY_NAME =
            Arrays.stream(values()).collect(Collectors.toUnmodifiableMap(PlayMode::simSparkName, Optional::of));

    private final String simSparkName;

    PlayMode(String simSparkName) {
        this.simSparkName = simSparkName;
    }

    /**
     * Names the play mode in SimSpark's messages.
     *
     * @return the name with SimSpark's mixed spelling, such as {@code KickOff_Left}
     */
    public String simSparkName() {
        return simSparkName;
    }

    /**
     * Names the team that brings the ball into play while the other one keeps away: at a kick-off, kick-in, corner, goal kick,
     * free kick or pass.
     *
     * @return the team; empty if both may play the ball or nobody may
     */
    public Optional<TeamSide> kicker() {
        return switch (this) {
            case KICK_OFF_LEFT,
                    KICK_IN_LEFT,
                    CORNER_KICK_LEFT,
                    GOAL_KICK_LEFT,
                    FREE_KICK_LEFT,
                    DIRECT_FREE_KICK_LEFT,
                    PASS_LEFT -> Optional.of(TeamSide.LEFT);
            case KICK_OFF_RIGHT,
                    KICK_IN_RIGHT,
                    CORNER_KICK_RIGHT,
                    GOAL_KICK_RIGHT,
                    FREE_KICK_RIGHT,
                    DIRECT_FREE_KICK_RIGHT,
                    PASS_RIGHT -> Optional.of(TeamSide.RIGHT);
            default -> Optional.empty();
        };
    }

    /**
     * Finds a play mode by its name in SimSpark's messages.
     *
     * @param simSparkName the exact name
     * @return the play mode, or empty for a name of a newer server
     */
    public static Optional<PlayMode> ofSimSparkName(String simSparkName) {
        return BY_NAME.getOrDefault(simSparkName, Optional.empty());
    }
}
