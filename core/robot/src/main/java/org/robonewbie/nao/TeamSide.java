package org.robonewbie.nao;

/** The side of the pitch that a team defends in the first half. The first team to join is the left team. */
public enum TeamSide {
    /** The side of the team that attacks along positive x, towards the goal posts G1R and G2R. */
    LEFT,
    /** The side of the team that attacks along negative x, towards the goal posts G1L and G2L. */
    RIGHT;

    /**
     * Converts a point from the world frame to the frame of the team on this side, or back; both have their origin at the centre spot.
     *
     * @param place the point; x points from the left goal to the right one in the world frame, and towards the opponents' goal in the
     *     team's
     * @return the point in the other frame
     */
    public Vector3 inOtherFrame(Vector3 place) {
        return this == LEFT ? place : new Vector3(-place.x(), -place.y(), place.z());
    }

    /** {@return the opponents' side} */
    public TeamSide opponent() {
        return this == LEFT ? RIGHT : LEFT;
    }
}
