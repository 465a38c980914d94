package org.robonewbie.nao;

/** The side of the pitch that a team defends in the first half. The first team to join is the left team. */
public enum TeamSide {
    /** The side of the team that attacks along positive x, towards the goal posts G1R and G2R. */
    LEFT,
    /** The side of the team that attacks along negative x, towards the goal posts G1L and G2L. */
    RIGHT;

    /** {@return the opponents' side} */
    public TeamSide opponent() {
        return this == LEFT ? RIGHT : LEFT;
    }
}
