package org.robonewbie.simulator.world;

import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.Material.Bounce;

/**
 * Surface materials with the effective values of rcssserver3d 0.7.3, in which some lines of the scene files fail
 * silently. All materials except that of movable objects are SimSpark's.
 */
final class SurfaceMaterials {

    /** Ground plane; does not bounce. */
    static final Material GROUND =
            new Material(Optional.empty(), OptionalDouble.of(0.2), OptionalDouble.empty(), OptionalDouble.of(5e-3));

    /** Goal walls and outer walls; SimSpark's default. */
    static final Material WALL = new Material(
            Optional.of(new Bounce(0.8, 2.0)), OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty());

    /** The ball: very soft. */
    static final Material BALL = new Material(
            Optional.of(new Bounce(0.8, 0.8)), OptionalDouble.of(0.5), OptionalDouble.of(0.05), OptionalDouble.of(0.6));

    /** Movable objects: like the ground, but with more slip, so that they yield to a push and stop when it ends. */
    static final Material THING =
            new Material(Optional.empty(), OptionalDouble.of(0.2), OptionalDouble.empty(), OptionalDouble.of(0.1));

    /** All links of a robot. */
    static final Material ROBOT =
            new Material(Optional.empty(), OptionalDouble.of(0.6), OptionalDouble.of(1e-4), OptionalDouble.of(5e-3));

    private SurfaceMaterials() {}
}
