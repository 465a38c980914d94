package org.robonewbie.workshop.fidelity;

/**
 * How far a simulation may be off before it counts as different.
 *
 * @param jointDegrees any joint; half a unit of the last printed digit comes from printing alone
 * @param torsoMetres torso position
 * @param torsoDegrees torso orientation
 * @param ballMetres ball position
 */
record Tolerances(double jointDegrees, double torsoMetres, double torsoDegrees, double ballMetres) {

    /** What the project has set itself. */
    static final Tolerances STANDARD = new Tolerances(0.01, 1e-4, 0.05, 1e-4);
}
