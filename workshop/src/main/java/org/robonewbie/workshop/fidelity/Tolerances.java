package org.robonewbie.workshop.fidelity;

/**
 * Deviations beyond which the simulation counts as diverged.
 *
 * @param jointDegrees any joint angle; rounding alone contributes half a unit of the last printed digit
 * @param torsoMetres torso position
 * @param torsoDegrees torso orientation
 * @param ballMetres ball position
 */
record Tolerances(double jointDegrees, double torsoMetres, double torsoDegrees, double ballMetres) {

    /** Tolerances of the fidelity bench. */
    static final Tolerances STANDARD = new Tolerances(0.01, 1e-4, 0.05, 1e-4);
}
