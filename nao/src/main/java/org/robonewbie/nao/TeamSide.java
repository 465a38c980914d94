package org.robonewbie.nao;

/** The half of the pitch that a team defends in the first half: the first team that joins plays on the left. */
public enum TeamSide {
    /** Attacks in the direction of growing x, towards the goal posts G1R and G2R. */
    LEFT,
    /** Attacks in the direction of falling x, towards the goal posts G1L and G2L. */
    RIGHT;

    /**
     * Names the other side.
     *
     * @return the opponents' side
     */
    public TeamSide opponent() {
        return this == LEFT ? RIGHT : LEFT;
    }
}
