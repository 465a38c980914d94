package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.RigidBody;

/** The objects of a landscape in the physical world: static colliders and movable bodies. */
public final class PlacedThings {

    private final Landscape landscape;
    private final List<Optional<RigidBody>> bodies = new ArrayList<>();

    PlacedThings(Assembly scenery, Landscape landscape) {
        this.landscape = landscape;
        landscape.things().forEach(thing -> bodies.add(build(scenery, thing)));
    }

    private static Optional<RigidBody> build(Assembly scenery, Thing thing) {
        Shape shape = new Shape.Box(thing.size());
        if (!thing.isMovable()) {
            scenery.addFixture(BodyPose.of(thing.pose()), shape, SurfaceMaterials.GROUND, Pitch.SCENERY);
            return Optional.empty();
        }
        RigidBody body = scenery.addBody(MassDistribution.of(shape, thing.massKg()), thing.centre());
        body.setRotation(BodyPose.of(thing.pose()).rotation());
        scenery.addCollider(body, BodyPose.ORIGIN, shape, SurfaceMaterials.THING, Pitch.SCENERY);
        return Optional.of(body);
    }

    /** {@return the initial landscape} */
    public Landscape landscape() {
        return landscape;
    }

    /** {@return the objects at their current poses, in the order of the landscape} */
    public List<Thing> now() {
        List<Thing> things = new ArrayList<>();
        for (int i = 0; i < bodies.size(); i++) {
            Thing thing = landscape.things().get(i);
            things.add(bodies.get(i).map(body -> thing.at(body.pose().toPose())).orElse(thing));
        }
        return things;
    }

    /** Moves all objects back to their initial poses. */
    public void reset() {
        for (int i = 0; i < bodies.size(); i++) {
            reset(i);
        }
    }

    private void reset(int index) {
        BodyPose start = BodyPose.of(landscape.things().get(index).pose());
        place(index, LinkMotion.between(start, start, 0));
    }

    /**
     * Sets the pose and velocity of an object. Has no effect on a static object.
     *
     * @param index index in the landscape
     * @param motion new pose and velocity
     */
    public void place(int index, LinkMotion motion) {
        bodies.get(index).ifPresent(body -> {
            body.setPosition(WorldLimits.position(motion.pose().position()));
            body.setRotation(motion.pose().rotation());
            body.setVelocity(WorldLimits.velocity(motion.velocity()));
            body.setAngularVelocity(motion.radiansPerSecond());
            body.wake();
        });
    }

    /** Moves objects that have left the world limits back to their initial poses. */
    void finishStep() {
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).filter(body -> !WorldLimits.isWithin(body)).isPresent()) {
                reset(i);
            }
        }
    }
}
