package org.robonewbie.simulator.landscape;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;

/**
 * A box in the world: a wall, a slope, a step, or something to push. SimSpark would have it as a {@code Box} collider in a scene
 * file.
 *
 * <pre>{@code
 * Thing step = Thing.fixed("step", new Vector3(0.3, 2, 0.05), new Vector3(1, 0, 0.025));
 * Thing crate = Thing.movable("crate", new Vector3(0.5, 0.5, 0.5), new Vector3(1, 0, 0.25), 2);
 * }</pre>
 *
 * @param name what it is, such as {@code wall}
 * @param size its edges along its own axes, metres
 * @param massKg its mass in kilograms; 0 if it never moves
 * @param pose where its centre is in the world frame and how it is turned
 */
public record Thing(String name, Vector3 size, double massKg, Pose pose) {

    /**
     * Describes something that never moves.
     *
     * @param name what it is
     * @param size its edges, metres
     * @param centre its centre, metres
     * @return the thing, parallel to the world's axes
     */
    public static Thing fixed(String name, Vector3 size, Vector3 centre) {
        return movable(name, size, centre, 0);
    }

    /**
     * Describes something that robots can push.
     *
     * @param name what it is
     * @param size its edges, metres
     * @param centre its centre, metres
     * @param massKg its mass in kilograms
     * @return the thing, parallel to the world's axes
     */
    public static Thing movable(String name, Vector3 size, Vector3 centre, double massKg) {
        return new Thing(name, size, massKg, new Pose(centre, Rotation.NONE));
    }

    /**
     * Says where it is now.
     *
     * @param now its pose
     * @return the same thing there
     */
    public Thing at(Pose now) {
        return new Thing(name, size, massKg, now);
    }

    /** {@return whether it can be moved} */
    public boolean isMovable() {
        return massKg > 0;
    }

    /** {@return its centre, metres} */
    public Vector3 centre() {
        return pose.position();
    }
}
