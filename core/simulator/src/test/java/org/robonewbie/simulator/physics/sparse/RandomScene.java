package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/** A few trees of bodies in random poses close to the ground and to each other; equal seeds give equal scenes. */
final class RandomScene {

    private static final Material SOFT =
            new Material(Optional.empty(), OptionalDouble.of(0.6), OptionalDouble.of(1e-4), OptionalDouble.of(5e-3));
    private static final Material BOUNCING = new Material(
            Optional.of(new Material.Bounce(0.8, 0.8)),
            OptionalDouble.of(0.5),
            OptionalDouble.of(0.05),
            OptionalDouble.of(0.6));

    private final PhysicsWorld world;
    private final Random random;
    private final List<RigidBody> bodies = new ArrayList<>();
    private final List<MotorHinge> hinges = new ArrayList<>();

    RandomScene(PhysicsWorld world, long seed) {
        this.world = world;
        this.random = new Random(seed);
        world.addGround(SOFT, "ground");
        addBall();
        int trees = 1 + random.nextInt(3);
        for (int i = 0; i < trees; i++) {
            addTree(new Vector3(between(-0.3, 0.3), between(-0.3, 0.3), between(0.05, 0.4)));
        }
        bodies.forEach(this::kick);
    }

    List<RigidBody> bodies() {
        return bodies;
    }

    List<MotorHinge> hinges() {
        return hinges;
    }

    PhysicsWorld world() {
        return world;
    }

    void step() {
        world.findContacts();
        world.step(0.02);
    }

    private void addBall() {
        Shape shape = new Shape.Sphere(0.042);
        RigidBody ball = world.scenery().addBody(MassDistribution.of(shape, 0.026), new Vector3(0, 0, 0.05));
        world.scenery().addCollider(ball, BodyPose.ORIGIN, shape, BOUNCING, "ball");
        bodies.add(ball);
    }

    private void addTree(Vector3 root) {
        Assembly assembly = world.addAssembly();
        List<RigidBody> tree = new ArrayList<>();
        int size = 1 + random.nextInt(9);
        for (int i = 0; i < size; i++) {
            tree.add(addBody(
                    assembly, i == 0 ? root : near(tree.get(random.nextInt(i)).position())));
        }
        for (int i = 1; i < size; i++) {
            RigidBody parent = tree.get(random.nextInt(i));
            hinges.add(assembly.addHinge(tree.get(i), parent, hinge(tree.get(i).position())));
        }
        bodies.addAll(tree);
    }

    private RigidBody addBody(Assembly assembly, Vector3 place) {
        Shape shape = switch (random.nextInt(3)) {
            case 0 -> new Shape.Box(new Vector3(between(0.02, 0.2), between(0.02, 0.2), between(0.02, 0.2)));
            case 1 -> new Shape.Sphere(between(0.01, 0.1));
            default -> new Shape.Capsule(between(0.01, 0.05), between(0.02, 0.1));
        };
        RigidBody body = assembly.addBody(MassDistribution.of(shape, between(0.05, 1.2)), place);
        assembly.addCollider(body, BodyPose.ORIGIN, shape, random.nextInt(4) == 0 ? BOUNCING : SOFT, "limb");
        return body;
    }

    private HingeDefinition hinge(Vector3 body) {
        double middle = between(-0.1, 0.1);
        Vector3 axis = direction();
        return new HingeDefinition(
                near(body),
                axis,
                middle - between(0, 0.1),
                middle + between(0, 0.1),
                random.nextInt(3) == 0 ? 0.05 : 10,
                random.nextInt(2));
    }

    private void kick(RigidBody body) {
        body.setVelocity(direction().times(between(0, 2)));
        body.setAngularVelocity(direction().times(between(0, 10)));
        if (random.nextBoolean()) {
            body.setRotation(RotationMatrix.aboutZ(between(-0.02, 0.02)).after(aboutX(between(-0.02, 0.02))));
        }
    }

    /** Turned about one axis only, boxes would keep parallel edges, and rounding would choose where they touch. */
    private static RotationMatrix aboutX(double radians) {
        double cos = Math.cos(radians);
        double sin = Math.sin(radians);
        return new RotationMatrix(1, 0, 0, 0, cos, -sin, 0, sin, cos);
    }

    void command() {
        for (MotorHinge hinge : hinges) {
            hinge.setSpeed(random.nextInt(4) == 0 ? 0 : between(-6, 6));
        }
    }

    private Vector3 near(Vector3 place) {
        return place.plus(direction().times(0.08));
    }

    private Vector3 direction() {
        Vector3 any = new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
        return any.times(1 / any.length());
    }

    private double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }
}
