package org.robonewbie.simulator.landscape;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;

/**
 * Box in the world, such as a wall, a slope, a step or a crate.
 *
 * <pre>{@code
 * Thing step = Thing.fixed("step", new Vector3(0.3, 2, 0.05), new Vector3(1, 0, 0.025));
 * Thing crate = Thing.movable("crate", new Vector3(0.5, 0.5, 0.5), new Vector3(1, 0, 0.25), 2);
 * }</pre>
 *
 * @param name name of the kind of object, such as {@code wall}
 * @param size edge lengths along its axes in metres
 * @param massKg mass in kilograms; 0 for a static thing
 * @param pose pose of its centre in the world frame
 */
public record Thing(String name, Vector3 size, double massKg, Pose pose) {

    /**
     * Creates a static thing.
     *
     * @param name name of its kind
     * @param size edge lengths in metres
     * @param centre centre in metres
     * @return the thing, parallel to the world axes
     */
    public static Thing fixed(String name, Vector3 size, Vector3 centre) {
        return movable(name, size, centre, 0);
    }

    /**
     * Creates a thing that robots can push.
     *
     * @param name name of its kind
     * @param size edge lengths in metres
     * @param centre centre in metres
     * @param massKg mass in kilograms
     * @return the thing, parallel to the world axes
     */
    public static Thing movable(String name, Vector3 size, Vector3 centre, double massKg) {
        return new Thing(name, size, massKg, new Pose(centre, Rotation.NONE));
    }

    /**
     * Returns a copy with the given pose.
     *
     * @param now the new pose
     * @return the moved thing
     */
    public Thing at(Pose now) {
        return new Thing(name, size, massKg, now);
    }

    /** {@return whether this object can be moved} */
    public boolean isMovable() {
        return massKg > 0;
    }

    /** {@return the centre in metres} */
    public Vector3 centre() {
        return pose.position();
    }
}
