package org.robonewbie.agent.motion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.Interpolation;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.MotionFile;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;

/** Files that say {@code // play: 1.1} give the commands of RoboNewbie 1.1, whatever the joints are sensed to do. */
class OriginalMotionTest {

    private static final double CYCLE = 0.02;

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void commandsOfMadeUpFilesAreThoseOfTheRule(long seed) {
        Random random = new Random(seed);
        MotionFile file = MotionFile.parse("made-up", "// play: 1.1\n" + madeUp(random));
        List<double[]> sensed = new ArrayList<>();
        List<double[]> played = new ArrayList<>();
        MotionPlayer player = MotionPlayer.of(file, 1, Interpolation.LINEAR);

        while (!player.isFinished()) {
            sensed.add(IntStream.range(0, Joint.COUNT)
                    .mapToDouble(joint -> middle(joint) - 1 + 2 * random.nextDouble())
                    .toArray());
            played.add(cycle(player, sensed.get(sensed.size() - 1)));
        }

        List<double[]> expected = rule(file.motion().keyframes(), sensed);
        assertThat(played).hasSameSizeAs(expected);
        for (int i = 0; i < expected.size(); i++) {
            assertThat(played.get(i)).as("cycle %d", i).containsExactly(expected.get(i), within(1e-9));
        }
    }

    @Test
    void robotRestsForOneCycleAtEachKeyframeAndOneAfterTheLast() {
        MotionFile file = MotionFile.parse("salute", "// play: 1.1\n" + line(100, 3) + line(119, -2));
        MotionPlayer player = MotionPlayer.of(file, 1, Interpolation.LINEAR);
        List<Boolean> moving = new ArrayList<>();

        while (!player.isFinished()) {
            moving.add(cycle(player, new double[Joint.COUNT])[0] != 0);
        }

        assertThat(moving).containsExactly(true, true, true, true, false, true, true, true, true, false, false);
        assertThat(player.seconds()).isCloseTo(0.22, within(1e-9));
    }

    @Test
    void keyframeOfOneCycleIsNotApproachedAndOneThatIsReachedEndsAtOnce() {
        MotionFile file = MotionFile.parse("short", "// play: 1.1\n" + line(20, 3) + line(1000, 0));
        MotionPlayer player = MotionPlayer.of(file, 1, Interpolation.LINEAR);
        int cycles = 0;

        while (!player.isFinished()) {
            assertThat(cycle(player, new double[Joint.COUNT])).containsOnly(0);
            cycles++;
        }

        assertThat(cycles).isEqualTo(3);
    }

    private double[] cycle(MotionPlayer player, double... sensed) {
        for (Joint joint : Joint.values()) {
            joints.sense(joint, sensed[joint.ordinal()]);
        }
        player.step(motors);
        motors.endCycle();
        return motors.sentDegreesPerSecond();
    }

    /** The rule as it is documented, written down once more. */
    private static List<double[]> rule(List<Keyframe> keyframes, List<double[]> sensed) {
        List<double[]> commands = new ArrayList<>();
        for (Keyframe keyframe : keyframes) {
            double[] previous = new double[Joint.COUNT];
            int left = Math.max(1, keyframe.durationMillis() / 20);
            boolean resting = false;
            while (!resting) {
                double[] steps = new double[Joint.COUNT];
                for (Joint joint : Joint.values()) {
                    int i = joint.ordinal();
                    double way = keyframe.posture().degrees(joint) - (sensed.get(commands.size())[i] + previous[i]);
                    steps[i] = left > 1 ? way / (left - 1) : 0;
                }
                commands.add(IntStream.range(0, Joint.COUNT)
                        .mapToDouble(i -> steps[i] / CYCLE)
                        .toArray());
                resting = IntStream.range(0, Joint.COUNT).allMatch(i -> steps[i] == 0);
                previous = steps;
                left--;
            }
        }
        commands.add(new double[Joint.COUNT]);
        return commands;
    }

    /** Keyframes near to the sensed angles, so that no command is beyond what a motor can do; some of them short. */
    private static String madeUp(Random random) {
        return IntStream.range(0, 6)
                .mapToObj(i -> line(i == 2 ? 20 : 300 + random.nextInt(300), 0, random))
                .collect(Collectors.joining());
    }

    /** An angle from which the joint can turn both ways. */
    private static double middle(int index) {
        Joint joint = Joint.values()[index];
        return Math.max(joint.minDegrees() + 15, Math.min(joint.maxDegrees() - 15, 0));
    }

    private static String line(int millis, double degrees, Random... random) {
        return millis + " "
                + IntStream.range(0, Joint.COUNT)
                        .mapToObj(i -> Joint.values()[i])
                        .map(joint -> random.length == 0
                                ? joint.clampDegrees(degrees)
                                : middle(joint.ordinal()) - 2 + 4 * random[0].nextDouble())
                        .map(String::valueOf)
                        .collect(Collectors.joining(" "))
                + "\n";
    }
}
