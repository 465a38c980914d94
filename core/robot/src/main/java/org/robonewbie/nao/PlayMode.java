package org.robonewbie.nao;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The game states set by the referee, with the names and in the order of SimSpark 0.7.3, followed by those that only RCSSServerMJ
 * has.
 */
public enum PlayMode {
    /** Play has not begun; robots may be beamed. */
    BEFORE_KICK_OFF("BeforeKickOff"),
    /** The left team kicks off. */
    KICK_OFF_LEFT("KickOff_Left"),
    /** The right team kicks off. */
    KICK_OFF_RIGHT("KickOff_Right"),
    /** The game is running. */
    PLAY_ON("PlayOn"),
    /** The ball left the field over the side line; the left team takes the kick-in. */
    KICK_IN_LEFT("KickIn_Left"),
    /** The ball left the field over the side line; the right team takes the kick-in. */
    KICK_IN_RIGHT("KickIn_Right"),
    /** Corner kick for the left team. */
    CORNER_KICK_LEFT("corner_kick_left"),
    /** Corner kick for the right team. */
    CORNER_KICK_RIGHT("corner_kick_right"),
    /** Goal kick for the left team, from its goal area. */
    GOAL_KICK_LEFT("goal_kick_left"),
    /** Goal kick for the right team, from its goal area. */
    GOAL_KICK_RIGHT("goal_kick_right"),
    /** The left team was offside; this rule is disabled in SimSpark. */
    OFFSIDE_LEFT("offside_left"),
    /** The right team was offside; this rule is disabled in SimSpark. */
    OFFSIDE_RIGHT("offside_right"),
    /** The game is over. */
    GAME_OVER("GameOver"),
    /** The left team has scored; robots may be beamed. */
    GOAL_LEFT("Goal_Left"),
    /** The right team has scored; robots may be beamed. */
    GOAL_RIGHT("Goal_Right"),
    /** Indirect free kick for the left team. */
    FREE_KICK_LEFT("free_kick_left"),
    /** Indirect free kick for the right team. */
    FREE_KICK_RIGHT("free_kick_right"),
    /** Direct free kick for the left team. */
    DIRECT_FREE_KICK_LEFT("direct_free_kick_left"),
    /** Direct free kick for the right team. */
    DIRECT_FREE_KICK_RIGHT("direct_free_kick_right"),
    /** Pass mode for the left team; opponents must keep away from the ball. */
    PASS_LEFT("pass_left"),
    /** Pass mode for the right team; opponents must keep away from the ball. */
    PASS_RIGHT("pass_right"),
    /** Penalty kick for the left team, from the penalty spot; RCSSServerMJ only. */
    PENALTY_KICK_LEFT("penalty_kick_left"),
    /** Penalty kick for the right team, from the penalty spot; RCSSServerMJ only. */
    PENALTY_KICK_RIGHT("penalty_kick_right"),
    /** Penalty shoot-out: the left team's turn; RCSSServerMJ only. */
    PENALTY_SHOOT_LEFT("penalty_shoot_left"),
    /** Penalty shoot-out: the right team's turn; RCSSServerMJ only. */
    PENALTY_SHOOT_RIGHT("penalty_shoot_right");

    private static final List<PlayMode> SIM_SPARK =
            Arrays.stream(values()).limit(PASS_RIGHT.ordinal() + 1L).toList();

    /** Cached results of {@link #ofSimSparkName}, which is called in every cycle. */
    private static final Map<String, Optional<PlayMode>> BY_NAME =
            SIM_SPARK.stream().collect(Collectors.toUnmodifiableMap(PlayMode::simSparkName, Optional::of));

    private final String simSparkName;

    PlayMode(String simSparkName) {
        this.simSparkName = simSparkName;
    }

    /** {@return the play modes of SimSpark, in its order} */
    public static List<PlayMode> simSparkModes() {
        return SIM_SPARK;
    }

    /** {@return the name in messages, such as {@code KickOff_Left} or {@code goal_kick_left}} */
    public String simSparkName() {
        return simSparkName;
    }

    /**
     * {@return the team that puts the ball into play while the other team keeps its distance (kick-off, kick-in, corner kick,
     * goal kick, free kick, pass); empty if both teams or neither may play the ball}
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
     * Looks up a play mode by its name in SimSpark's messages.
     *
     * @param simSparkName the exact name
     * @return the play mode; empty for an unknown name, which a newer server may send
     */
    public static Optional<PlayMode> ofSimSparkName(String simSparkName) {
        return BY_NAME.getOrDefault(simSparkName, Optional.empty());
    }

    /**
     * Looks up a play mode by its name in the messages of any server.
     *
     * @param name the exact name
     * @return the play mode; empty for an unknown name
     */
    public static Optional<PlayMode> ofName(String name) {
        return Arrays.stream(values())
                .filter(mode -> mode.simSparkName.equals(name))
                .findFirst();
    }
}
