package org.robonewbie.team.talk;

/** A player's role in its team. */
public enum TeamRole {
    /** Guards the goal; number 1 in a team of eight or more. */
    KEEPER("white"),
    /** Plays the ball; only one player at a time has this role. */
    STRIKER("red"),
    /** Follows the striker and takes over if the striker loses the ball. */
    SUPPORTER("orange"),
    /** Waits between the ball and the opponents' goal for passes. */
    FORWARD("yellow"),
    /** Waits for passes on the left. */
    LEFT_WING("yellow"),
    /** Waits for passes on the right. */
    RIGHT_WING("yellow"),
    /** Stands between the ball and the team's own goal. */
    SWEEPER("blue"),
    /** Defends on the left. */
    LEFT_BACK("blue"),
    /** Defends on the right. */
    RIGHT_BACK("blue"),
    /** Covers the midfield on the left. */
    LEFT_MIDFIELD("green"),
    /** Covers the midfield on the right. */
    RIGHT_MIDFIELD("green");

    private final String colour;

    TeamRole(String colour) {
        this.colour = colour;
    }

    /** {@return the CSS colour for drawings of players with this role} */
    public String colour() {
        return colour;
    }
}
