package org.robonewbie.workshop.sparring;

/** A number that is summed over the matches of a team. */
enum Figure {
    /** Goals. */
    GOALS,
    /** Seconds of play, set plays included, line-ups excluded. */
    SECONDS,
    /** Sum of the ball's distance from the middle line towards the opponents' goal, times seconds. */
    TERRITORY,
    /** Seconds with a player of this team nearest to the ball and within 0.5 m of it. */
    POSSESSION,
    /** Seconds with the ball within 3 m of the middle of the team's own goal line. */
    DANGER,
    /** Sum of the number of players within 2.5 m of the ball, times seconds. */
    NEAR_BALL,
    /** Kicks: a player accelerates the ball to more than 1.5 m/s. */
    KICKS,
    /** Metres towards the opponents' goal that the ball has gained four seconds after a kick, or when play stops. */
    KICKED_METRES,
    /** Falls. */
    FALLS,
    /** Kick-offs taken. */
    KICK_OFFS,
    /** Kick-offs after which the next robot to touch the ball was a teammate of the taker. */
    KICK_OFFS_KEPT,
    /** Kick-ins, corners, goal kicks and free kicks taken. */
    SET_PLAYS,
    /** Set plays after which the next robot to touch the ball was a teammate of the taker. */
    SET_PLAYS_KEPT
}
