package org.robonewbie.nao.kinematics;

import org.robonewbie.nao.Vector3;

/**
 * Position and turn of something that moves on and turns along its own axes, step by step, like somebody who is told the way.
 * For calculations in each cycle, which shall make no garbage; what is finished is a {@link Pose}.
 *
 * <pre>{@code
 * pose.reset();
 * pose.move(0, 0, -0.115);      // from the torso down to the hips
 * pose.turnAboutY(-leanDegrees);
 * pose.move(0, 0, -0.2);        // down to the ground, whatever the torso's lean
 * }</pre>
 */
public final class MutablePose {

    private final double[] position = new double[3];
    private final double[] rotation = new double[9];

    /** Creates a pose at the origin, not turned. */
    public MutablePose() {
        reset();
    }

    /** Goes back to the origin and turns back. */
    public void reset() {
        for (int i = 0; i < 9; i++) {
            rotation[i] = i % 4 == 0 ? 1 : 0;
        }
        position[0] = 0;
        position[1] = 0;
        position[2] = 0;
    }

    /**
     * Takes over another pose.
     *
     * @param pose the pose
     */
    public void set(Pose pose) {
        put(0, pose.rotation().apply(new Vector3(1, 0, 0)));
        put(1, pose.rotation().apply(new Vector3(0, 1, 0)));
        put(2, pose.rotation().apply(new Vector3(0, 0, 1)));
        position[0] = pose.position().x();
        position[1] = pose.position().y();
        position[2] = pose.position().z();
    }

    /**
     * Goes along its own axes.
     *
     * @param x metres forward
     * @param y metres to the left
     * @param z metres up
     */
    public void move(double x, double y, double z) {
        for (int row = 0; row < 3; row++) {
            position[row] += rotation[3 * row] * x + rotation[3 * row + 1] * y + rotation[3 * row + 2] * z;
        }
    }

    /**
     * Turns about its own axis that points forward.
     *
     * @param degrees positive lets the left side rise
     */
    public void turnAboutX(double degrees) {
        turn(1, 2, degrees);
    }

    /**
     * Turns about its own axis that points to the left.
     *
     * @param degrees positive bows forward
     */
    public void turnAboutY(double degrees) {
        turn(2, 0, degrees);
    }

    /**
     * Turns about its own axis that points up.
     *
     * @param degrees positive is to the left
     */
    public void turnAboutZ(double degrees) {
        turn(0, 1, degrees);
    }

    /** A component of the position in metres: 0 is x, 1 is y, 2 is z. */
    double position(int component) {
        return position[component];
    }

    /** An element of the rotation matrix. */
    double rotation(int row, int column) {
        return rotation[3 * row + column];
    }

    /** Turns the first of two axes towards the second one. */
    private void turn(int first, int second, double degrees) {
        double cosine = Math.cos(Math.toRadians(degrees));
        double sine = Math.sin(Math.toRadians(degrees));
        for (int row = 0; row < 9; row += 3) {
            double a = rotation[row + first];
            double b = rotation[row + second];
            rotation[row + first] = cosine * a + sine * b;
            rotation[row + second] = cosine * b - sine * a;
        }
    }

    private void put(int column, Vector3 axis) {
        rotation[column] = axis.x();
        rotation[3 + column] = axis.y();
        rotation[6 + column] = axis.z();
    }
}
