package org.robonewbie.workshop.fidelity;

import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;

/** Equality of numbers that SimSpark prints with two decimals: they differ by at most one unit in the last digit. */
final class Printed {

    private static final double DIGITS = 100;
    private static final double ONE_UNIT_AND_ROUNDING = 0.0101;

    private Printed() {}

    static boolean equal(double exact, double printed) {
        return Math.abs(Math.rint(exact * DIGITS) / DIGITS - printed) < ONE_UNIT_AND_ROUNDING;
    }

    static boolean equal(Vector3 exact, Vector3 printed) {
        return equal(exact.x(), printed.x()) && equal(exact.y(), printed.y()) && equal(exact.z(), printed.z());
    }

    static boolean equal(FootForces exact, FootForces printed) {
        return equal(exact.left(), printed.left())
                && equal(exact.right(), printed.right())
                && equal(exact.leftToe(), printed.leftToe())
                && equal(exact.rightToe(), printed.rightToe());
    }

    private static boolean equal(Optional<FootForce> exact, Optional<FootForce> printed) {
        if (exact.isEmpty() || printed.isEmpty()) {
            return exact.isEmpty() && printed.isEmpty();
        }
        return equal(exact.get().point(), printed.get().point())
                && equal(exact.get().force(), printed.get().force());
    }
}
