package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Objects;
import java.util.Scanner;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.RobotType;

/**
 * What no recording of a server shows, as ODE 0.16.2 itself computes it: a C program with the bodies, joints and contacts of SimSpark
 * carried out the scripts and wrote between their lines where ball and robots were.
 */
class OdeReferenceTest {

    private static final double TOLERANCE_METRES = 2e-5;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "kick-right-type-0",
                "kick-left-type-4",
                "ball-against-post",
                "ball-on-roof-of-goal",
                "ball-into-goal",
                "ball-against-outer-wall",
                "ball-against-robot",
                "three-robots-touch",
                "robot-against-goal",
                "random-type-1",
                "random-type-3",
                "random-type-4",
                "fall-left-type-2"
            })
    void everythingMovesAsInOde(String name) throws IOException {
        SoccerWorld world = new SoccerWorld(SoccerField.LEAGUE);
        int comparisons = 0;

        try (Scanner script = open(name)) {
            while (script.hasNext()) {
                comparisons += obey(script, world) ? 1 : 0;
            }
        }

        assertThat(comparisons).isGreaterThan(20);
    }

    /** Carries out one line; tells whether it was a comparison. */
    private static boolean obey(Scanner script, SoccerWorld world) {
        switch (script.next()) {
            case "robot" -> world.addRobot(RobotType.values()[script.nextInt()]);
            case "place" -> {
                Robot robot = world.robots().get(script.nextInt());
                robot.moveUpright(vector(script), script.nextDouble());
                robot.wake();
            }
            case "ball" -> {
                world.ball().moveTo(vector(script));
                world.ball().setVelocity(vector(script));
            }
            case "set" -> setSpeed(world.robots().get(script.nextInt()), script.next(), script.nextDouble());
            case "step" -> {
                for (int steps = script.nextInt(); steps > 0; steps--) {
                    world.step();
                }
            }
            case "ballIsAt" -> {
                assertClose(world.ball().position(), vector(script));
                return true;
            }
            case "torsoIsAt" -> {
                assertClose(world.robots().get(script.nextInt()).torso().position(), vector(script));
                return true;
            }
            default -> throw new IllegalArgumentException("The script holds an unknown word.");
        }
        return false;
    }

    private static void setSpeed(Robot robot, String effector, double radiansPerSecond) {
        for (int i = 0; i < robot.nao().hinges().size(); i++) {
            Hinge hinge = robot.nao().hinges().get(i);
            if (hinge.effectorName().equals(effector)) {
                robot.setMotorSpeed(i, radiansPerSecond);
            }
        }
    }

    private static void assertClose(Vector3 ours, Vector3 odes) {
        assertThat(ours.distanceTo(odes)).isLessThan(TOLERANCE_METRES);
    }

    private static Vector3 vector(Scanner script) {
        return new Vector3(script.nextDouble(), script.nextDouble(), script.nextDouble());
    }

    private static Scanner open(String name) throws IOException {
        InputStream packed =
                Objects.requireNonNull(OdeReferenceTest.class.getResourceAsStream("ode/" + name + ".txt.gz"));
        return new Scanner(new GZIPInputStream(packed), StandardCharsets.US_ASCII).useLocale(Locale.ROOT);
    }
}
