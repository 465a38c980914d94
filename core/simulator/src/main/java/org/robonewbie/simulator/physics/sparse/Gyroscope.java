package org.robonewbie.simulator.physics.sparse;

/**
 * Gyroscopic torque of a body whose principal moments of inertia differ.
 *
 * <p>As in ODE, the torque is integrated implicitly so that it cannot add energy: with the angular momentum L, the inertia I
 * and the duration h of the step, it is {@code I w - L / h}, where w solves {@code (I - h [L]×) w = L / h} ({@code
 * dxStepIsland_Stage0_Bodies}). The computation uses body axes, where I is diagonal.
 */
final class Gyroscope {

    private Gyroscope() {}

    static void addTorque(double[] rotation, double[] inertia, double[] velocity, double seconds, double[] force) {
        double lx = inertia[0] * spin(rotation, velocity, 0);
        double ly = inertia[1] * spin(rotation, velocity, 1);
        double lz = inertia[2] * spin(rotation, velocity, 2);
        double a = seconds * lx;
        double b = seconds * ly;
        double c = seconds * lz;
        // Cramer's rule for the rows (Ix, c, -b), (-c, Iy, a), (b, -a, Iz).
        double ix = inertia[0];
        double iy = inertia[1];
        double iz = inertia[2];
        double determinant = ix * (iy * iz + a * a) + c * (c * iz + a * b) + b * (b * iy - a * c);
        double wx = lx * (iy * iz + a * a) + ly * (a * b - c * iz) + lz * (a * c + b * iy);
        double wy = lx * (a * b + c * iz) + ly * (ix * iz + b * b) + lz * (b * c - a * ix);
        double wz = lx * (a * c - b * iy) + ly * (a * ix + b * c) + lz * (ix * iy + c * c);
        double rate = 1 / seconds;
        double tx = rate * (ix * wx / determinant - lx);
        double ty = rate * (iy * wy / determinant - ly);
        double tz = rate * (iz * wz / determinant - lz);
        for (int axis = 0; axis < 3; axis++) {
            force[3 + axis] += rotation[3 * axis] * tx + rotation[3 * axis + 1] * ty + rotation[3 * axis + 2] * tz;
        }
    }

    private static double spin(double[] rotation, double[] velocity, int axis) {
        return rotation[axis] * velocity[3] + rotation[3 + axis] * velocity[4] + rotation[6 + axis] * velocity[5];
    }
}
