package org.robonewbie.workshop.fidelity;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.IntFunction;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;

/**
 * Scenario of a recording: either a robot that starts standing and executes fixed commands in each cycle, or balls that a
 * trainer sets in motion.
 *
 * @param name file name of the recording without extension
 * @param description description for the header
 * @param commands command text for each cycle of 20 ms; may be empty
 * @param balls balls to record instead of a robot; may be empty
 */
public record ReferenceScenario(String name, String description, List<String> commands, List<BallCase> balls) {

    private static final int CYCLES_OF_REST = 5;

    /** Stores unmodifiable copies of the lists. */
    public ReferenceScenario {
        commands = List.copyOf(commands);
        balls = List.copyOf(balls);
    }

    private ReferenceScenario(String name, String description, List<String> commands) {
        this(name, description, commands, List.of());
    }

    /** {@return the default scenarios: standing, falls, squats, marching, single joints, random reaching and balls} */
    public static List<ReferenceScenario> all() {
        return List.of(
                held("b_stand", "all joints at speed 0 for 5 s", 1, "(he1 0)", 250),
                held("d_fall_front", "both ankles +1.5 rad/s for 0.4 s, then 0", 20, "(lle5 1.5)(rle5 1.5)", 180),
                held("d_fall_back", "both ankles -1.5 rad/s for 0.4 s, then 0", 20, "(lle5 -1.5)(rle5 -1.5)", 180),
                held("d_fall_side", "both ankles roll +3 rad/s for 0.2 s, then 0", 10, "(lle6 3)(rle6 3)", 190),
                held("c_knee", "left knee -1 rad/s for 0.4 s, then 0", 20, "(lle4 -1)", 60),
                held("c_shoulder", "left shoulder +10 rad/s for 1.5 s, then 0", 75, "(lae1 10)", 60),
                moving("h_squat", "squats of 30 degrees, 2 s each, for 8 s", 400, ReferenceScenario::squat),
                moving("h_march", "marching in place, period 1.2 s, for 8 s", 400, ReferenceScenario::march),
                reaching("h_reach", 21),
                new ReferenceScenario("f_ball", "rolling, falling and lobbed balls", List.of(), BallCase.ALL));
    }

    /**
     * Creates a scenario from the commands of an existing recording.
     *
     * @param recording a recording of a robot with one run
     * @return a scenario with the same commands
     */
    public static ReferenceScenario of(Recording recording) {
        List<RecordedRow> rows = recording.runs().get(0).rows();
        return new ReferenceScenario(
                recording.name(),
                "the commands of " + recording.name(),
                rows.stream().map(RecordedRow::sent).toList());
    }

    private static ReferenceScenario held(String name, String what, int cycles, String command, int cyclesAfter) {
        return moving(name, what, cycles + cyclesAfter, i -> i < cycles ? command : i == cycles ? holdAll() : "");
    }

    private static ReferenceScenario moving(String name, String what, int cycles, IntFunction<String> command) {
        List<String> commands = new ArrayList<>();
        for (int i = 0; i < CYCLES_OF_REST; i++) {
            commands.add("");
        }
        for (int i = 0; i < cycles; i++) {
            commands.add(command.apply(i));
        }
        return new ReferenceScenario(name, what, commands);
    }

    private static String holdAll() {
        StringBuilder text = new StringBuilder();
        for (Joint joint : Joint.values()) {
            text.append(speed(joint.effectorName(), 0));
        }
        return text.toString();
    }

    private static String squat(int cycle) {
        double bend = Math.toRadians(15) * Math.PI * Math.sin(Math.PI * cycle * Cycle.SECONDS);
        return legs("l", bend) + legs("r", bend);
    }

    /**
     * Returns commands that lift the knees alternately while hips and ankles sway. Every joint returns to its start
     * angle after each period.
     */
    private static String march(int cycle) {
        double phase = 2 * Math.PI * cycle * Cycle.SECONDS / 1.2;
        double sway = Math.toRadians(4) * 2 * Math.PI / 1.2 * Math.cos(phase);
        double lift = Math.toRadians(12) * 2 * Math.PI / 0.6 * Math.sin(2 * phase);
        boolean left = Math.sin(phase) > 0;
        return speed("lle2", sway)
                + speed("rle2", sway)
                + speed("lle6", -sway)
                + speed("rle6", -sway)
                + legs("l", left ? lift : 0)
                + legs("r", left ? 0 : lift);
    }

    private static String legs(String side, double speed) {
        return speed(side + "le3", speed) + speed(side + "le4", -2 * speed) + speed(side + "le5", speed);
    }

    /**
     * Creates a scenario that moves every joint to a new random angle within the middle 30 % of its range each second.
     */
    private static ReferenceScenario reaching(String name, long seed) {
        Random random = new Random(seed);
        double[] degrees = new double[Joint.COUNT];
        List<String> perSecond = new ArrayList<>();
        for (int second = 0; second < 10; second++) {
            StringBuilder text = new StringBuilder();
            for (Joint joint : Joint.values()) {
                double middle = (joint.minDegrees() + joint.maxDegrees()) / 2;
                double goal = middle + 0.3 * (random.nextDouble() - 0.5) * (joint.maxDegrees() - joint.minDegrees());
                text.append(speed(joint.effectorName(), Math.toRadians(goal - degrees[joint.ordinal()])));
                degrees[joint.ordinal()] = goal;
            }
            perSecond.add(text.toString());
        }
        return moving(name, "random reaching, seed " + seed + ", for 10 s", 500, i -> perSecond.get(i / 50));
    }

    private static String speed(String effector, double radiansPerSecond) {
        return String.format(Locale.ROOT, "(%s %.4f)", effector, radiansPerSecond);
    }
}
