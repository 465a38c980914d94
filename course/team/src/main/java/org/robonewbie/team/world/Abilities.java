package org.robonewbie.team.world;

/**
 * What differs between robots for a player.
 *
 * @param movesLegs whether the player moves the legs: by motions, such as kicks and get-ups, and by small steps beside the ball
 * @param playersWithKeeper number of players from which a team has a keeper
 * @param robotMetres distance to keep from other robots
 * @param behindBallMetres distance behind the ball at which the robot begins to push it
 * @param aroundBallMetres distance at which the robot walks around the ball
 * @param arrivedMetres distance from a target at which the robot stops
 * @param maxSeconds longest time to the ball that a message can state, in seconds
 */
public record Abilities(
        boolean movesLegs,
        int playersWithKeeper,
        double robotMetres,
        double behindBallMetres,
        double aroundBallMetres,
        double arrivedMetres,
        double maxSeconds) {

    /** The NAO, in teams of up to eleven. */
    public static final Abilities NAO = new Abilities(true, 8, 0.5, 0.25, 0.35, 0.12, 24);

    /** The robots of RCSSServerMJ, in teams of up to seven. They walk by themselves and push the ball. */
    public static final Abilities LEAGUE = new Abilities(false, 5, 0.8, 0.6, 0.8, 0.3, 62);

    /**
     * Returns the abilities of a robot.
     *
     * @param modelName name of its model, such as {@code T1}
     * @return its abilities
     */
    public static Abilities of(String modelName) {
        return modelName.equals("NAO") ? NAO : LEAGUE;
    }
}
