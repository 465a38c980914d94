package org.robonewbie.team.talk;

/** What a player does for its team. */
public enum TeamRole {
    /** Keeps the goal; always number 1, in a team of eight or more. */
    KEEPER("white"),
    /** Plays the ball. Only one player at a time. */
    STRIKER("red"),
    /** Follows the striker, and takes the ball if that one loses it. */
    SUPPORTER("orange"),
    /** Waits for passes between ball and opponents' goal. */
    FORWARD("yellow"),
    /** Waits for passes on the left. */
    LEFT_WING("yellow"),
    /** Waits for passes on the right. */
    RIGHT_WING("yellow"),
    /** Stands between ball and own goal. */
    SWEEPER("blue"),
    /** Defends on the left. */
    LEFT_BACK("blue"),
    /** Defends on the right. */
    RIGHT_BACK("blue"),
    /** Keeps the middle on the left. */
    LEFT_MIDFIELD("green"),
    /** Keeps the middle on the right. */
    RIGHT_MIDFIELD("green");

    private final String colour;

    TeamRole(String colour) {
        this.colour = colour;
    }

    /** {@return the colour of its drawings} */
    public String colour() {
        return colour;
    }
}
