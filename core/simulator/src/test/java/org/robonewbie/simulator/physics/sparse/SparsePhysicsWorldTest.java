package org.robonewbie.simulator.physics.sparse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.Crew;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.ode.OdePhysicsWorld;
import org.robonewbie.simulator.server.ThreadCrew;
import org.robonewbie.simulator.world.BallProperties;
import org.robonewbie.simulator.world.PhysicsEngine;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

/** Our own step against the engine's: the same equations must give the same motion, up to rounding. */
class SparsePhysicsWorldTest {

    private static final int SCENES = 300;
    private static final double VELOCITY_TOLERANCE = 1e-7;
    private static final double NEWTON_TOLERANCE = 1e-5;

    @Test
    void oneStepOfAnyRandomSceneIsThatOfTheEngine() {
        for (long seed = 0; seed < SCENES; seed++) {
            RandomScene ours = stepped(new SparsePhysicsWorld(), seed);
            RandomScene theirs = stepped(new OdePhysicsWorld(), seed);

            for (int i = 0; i < ours.bodies().size(); i++) {
                RigidBody our = ours.bodies().get(i);
                RigidBody their = theirs.bodies().get(i);
                assertThat(our.velocity().distanceTo(their.velocity()))
                        .as("seed %d, body %d", seed, i)
                        .isLessThan(VELOCITY_TOLERANCE);
                assertThat(our.angularVelocity().distanceTo(their.angularVelocity()))
                        .as("seed %d, body %d", seed, i)
                        .isLessThan(10 * VELOCITY_TOLERANCE);
            }
        }
    }

    @Test
    void contactsOfAnyRandomSceneAreThoseOfTheEngineWithTheSameForce() {
        int compared = 0;
        for (long seed = 0; seed < SCENES; seed++) {
            List<Contact> ours = stepped(new SparsePhysicsWorld(), seed).world().contacts();
            List<Contact> theirs = stepped(new OdePhysicsWorld(), seed).world().contacts();

            assertThat(ours).as("seed %d", seed).hasSameSizeAs(theirs);
            for (Contact our : ours) {
                assertThat(theirs).as("seed %d", seed).anyMatch(their -> isSame(our, their));
                compared++;
            }
        }
        assertThat(compared).isGreaterThan(1000);
    }

    private static boolean isSame(Contact our, Contact their) {
        Vector3 theirForce = force(their);
        return our.first().owner().equals(their.first().owner())
                && our.second().owner().equals(their.second().owner())
                && our.position().distanceTo(their.position()) < 1e-12
                && force(our).distanceTo(theirForce) < NEWTON_TOLERANCE * (1 + theirForce.length());
    }

    private static Vector3 force(Contact contact) {
        double[] sums = new double[7];
        contact.addTo(sums);
        return new Vector3(sums[0], sums[1], sums[2]);
    }

    @Test
    void contactsBetweenBodiesComeInTheOrderOfTheEngine() {
        for (long seed = 0; seed < SCENES; seed++) {
            List<Vector3> ours = placesBetweenBodies(stepped(new SparsePhysicsWorld(), seed));
            List<Vector3> theirs = placesBetweenBodies(stepped(new OdePhysicsWorld(), seed));

            for (int i = 0; i < ours.size(); i++) {
                assertThat(ours.get(i).distanceTo(theirs.get(i)))
                        .as("seed %d, contact %d", seed, i)
                        .isLessThan(1e-12);
            }
        }
    }

    private static List<Vector3> placesBetweenBodies(RandomScene scene) {
        return scene.world().contacts().stream()
                .filter(contact -> !contact.second().owner().equals("ground"))
                .map(Contact::position)
                .toList();
    }

    private static RandomScene stepped(PhysicsWorld world, long seed) {
        RandomScene scene = new RandomScene(world, seed);
        scene.command();
        scene.step();
        return scene;
    }

    @ParameterizedTest
    @CsvSource({"1, 300, 1e-8", "3, 60, 1e-7"})
    void robotsThatThrashMoveAsInTheEngine(int robots, int cycles, double metres) {
        List<BodyPose> ours = thrash(PhysicsEngine.FAST, robots, cycles);
        List<BodyPose> theirs = thrash(PhysicsEngine.EXACT, robots, cycles);

        for (int i = 0; i < ours.size(); i++) {
            assertThat(ours.get(i).position().distanceTo(theirs.get(i).position()))
                    .isLessThan(metres);
        }
    }

    @Test
    void equalCallsGiveBitIdenticalWorlds() {
        assertThat(thrash(PhysicsEngine.FAST, 3, 100)).isEqualTo(thrash(PhysicsEngine.FAST, 3, 100));
    }

    @Test
    void helpOfOtherThreadsDoesNotChangeABit() {
        try (ThreadCrew crew = new ThreadCrew(3)) {
            assertThat(thrash(PhysicsEngine.FAST, 5, 200, crew))
                    .isEqualTo(thrash(PhysicsEngine.FAST, 5, 200, Crew.ALONE));
        }
    }

    private static List<BodyPose> thrash(PhysicsEngine engine, int robots, int cycles) {
        return thrash(engine, robots, cycles, Crew.ALONE);
    }

    private static List<BodyPose> thrash(PhysicsEngine engine, int robots, int cycles, Crew crew) {
        SoccerWorld world =
                new SoccerWorld(SoccerField.LEAGUE, BallProperties.STANDARD, engine.newWorld(), Landscape.SOCCER);
        world.setCrew(crew);
        Random random = new Random(5);
        for (int i = 0; i < robots; i++) {
            world.addRobot(RobotType.values()[i]).moveUpright(new Vector3(0.3 * i, 0, 0.5 + 0.2 * i), 70 * i);
        }
        for (int t = 0; t < cycles; t++) {
            for (Robot robot : world.robots()) {
                for (int hinge = 0; t % 25 == 0 && hinge < robot.nao().hinges().size(); hinge++) {
                    robot.setMotorSpeed(hinge, 6 * random.nextDouble() - 3);
                }
            }
            world.step();
        }
        List<BodyPose> poses = new ArrayList<>();
        for (Robot robot : world.robots()) {
            for (int link = 0; link < robot.nao().links().size(); link++) {
                poses.add(robot.linkPose(link));
            }
        }
        return poses;
    }

    @Test
    void robotFallsAsleepInTheSameCycleAsInTheEngine() {
        SoccerWorld ours = standing(PhysicsEngine.FAST);
        SoccerWorld theirs = standing(PhysicsEngine.EXACT);
        int cyclesAsleep = 0;

        for (int t = 0; t < 300; t++) {
            ours.step();
            theirs.step();
            boolean asleep = theirs.robots().get(0).isAsleep();
            cyclesAsleep += asleep ? 1 : 0;
            assertThat(ours.robots().get(0).isAsleep()).as("cycle %d", t).isEqualTo(asleep);
        }

        assertThat(cyclesAsleep).isBetween(1, 299);
    }

    private static SoccerWorld standing(PhysicsEngine engine) {
        SoccerWorld world =
                new SoccerWorld(SoccerField.LEAGUE, BallProperties.STANDARD, engine.newWorld(), Landscape.SOCCER);
        world.addRobot(RobotType.TYPE_0).moveUpright(new Vector3(0, 1, 0.39), 0);
        return world;
    }

    @Test
    void removedRobotTouchesNothingAnyMore() {
        SoccerWorld world = standing(PhysicsEngine.FAST);
        world.step();
        Robot robot = world.robots().get(0);
        world.ball().place(new Vector3(0, 1, 1));

        world.removeRobot(robot);
        for (int t = 0; t < 100; t++) {
            world.step();
        }

        assertThat(world.ball().position().z()).isLessThan(0.1);
    }

    /** Worlds of a thread share their working memory, and a pile of another test may just be forgotten; so this one has a thread of its own. */
    @Test
    void stepsInTheSteadyStateAllocateNothing() throws Exception {
        FutureTask<Long> rocking = new FutureTask<>(SparsePhysicsWorldTest::allocatedWhileRocking);
        new Thread(rocking).start();

        assertThat(rocking.get()).isLessThan(400);
    }

    private static long allocatedWhileRocking() {
        ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        PhysicsWorld world = new SparsePhysicsWorld();
        MotorHinge hinge = addRockingPair(world);
        rock(world, hinge, 400);

        long before = thread.getCurrentThreadAllocatedBytes();
        rock(world, hinge, 4_000);
        long allocated = thread.getCurrentThreadAllocatedBytes() - before;
        assertThat(world.contacts()).isNotEmpty();
        return allocated;
    }

    private static MotorHinge addRockingPair(PhysicsWorld world) {
        Material material = new Material(
                Optional.empty(), OptionalDouble.of(0.6), OptionalDouble.of(1e-4), OptionalDouble.of(5e-3));
        world.addGround(material, "ground");
        Assembly assembly = world.addAssembly();
        Shape box = new Shape.Box(new Vector3(0.2, 0.2, 0.1));
        RigidBody foot = assembly.addBody(MassDistribution.of(box, 1), new Vector3(0, 0, 0.05));
        RigidBody head = assembly.addBody(MassDistribution.of(box, 0.2), new Vector3(0, 0, 0.2));
        assembly.addCollider(foot, BodyPose.ORIGIN, box, material, "foot");
        assembly.addCollider(head, BodyPose.ORIGIN, box, material, "head");
        return assembly.addHinge(
                head, foot, new HingeDefinition(new Vector3(0, 0, 0.1), new Vector3(1, 0, 0), -1, 1, 10, 1));
    }

    private static void rock(PhysicsWorld world, MotorHinge hinge, int steps) {
        for (int step = 0; step < steps; step++) {
            hinge.setSpeed(step / 20 % 2 == 0 ? 0.5 : -0.5);
            world.findContacts();
            world.step(0.02);
        }
    }

    @Test
    void sceneryCannotBeRemoved() {
        assertThatThrownBy(() -> new SparsePhysicsWorld().scenery().remove())
                .isInstanceOf(UnsupportedOperationException.class)
                .hasMessage("The scenery cannot be removed. Discard the whole world instead.");
    }
}
