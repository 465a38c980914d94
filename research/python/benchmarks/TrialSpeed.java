import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/**
 * Measures the processor time that the simulator needs without Python for a step of 20 ms, in which a standing robot
 * moves all its joints, and for a reset to its settled standing posture. Prints both times in microseconds, as JSON.
 */
public class TrialSpeed {

    private static final int STEPS = 20_000;
    private static final int RESETS = 4_000;
    private static final int STEPS_BETWEEN = 20;
    private static final int STEPS_PER_EPISODE = 250;
    private static final ThreadMXBean CLOCK = ManagementFactory.getThreadMXBean();

    public static void main(String[] arguments) {
        try (Trial trial = Trial.direct(Scene.of(RobotStart.at(1.5, 0).after("stand")), 1, swaying())) {
            for (int i = 0; i < 3; i++) {
                steps(trial); // warms up the JIT compiler
            }
            double step = steps(trial);
            double reset = resets(trial);
            System.out.printf(Locale.ROOT, "{\"step\": %.1f, \"reset\": %.1f}%n", step, reset);
        }
    }

    private static Controller swaying() {
        int[] cycle = {0};
        return Controller.ofPolicy(readings -> {
            double[] speeds = new double[Joint.COUNT];
            cycle[0]++;
            for (int i = 0; i < speeds.length; i++) {
                speeds[i] = 10 * Math.cos(cycle[0] / 8.0 + i);
            }
            return speeds;
        });
    }

    private static double steps(Trial trial) {
        long before = CLOCK.getCurrentThreadCpuTime();
        for (int i = 1; i <= STEPS; i++) {
            trial.step();
            if (i % STEPS_PER_EPISODE == 0) {
                trial.reset(i, swaying());
            }
        }
        return (CLOCK.getCurrentThreadCpuTime() - before) / 1e3 / STEPS;
    }

    /** Runs a few untimed steps between two resets, so that there is something to reset. */
    private static double resets(Trial trial) {
        long spent = 0;
        for (int i = 0; i < RESETS; i++) {
            for (int step = 0; step < STEPS_BETWEEN; step++) {
                trial.step();
            }
            long before = CLOCK.getCurrentThreadCpuTime();
            trial.reset(i, swaying());
            spent += i < RESETS / 2 ? 0 : CLOCK.getCurrentThreadCpuTime() - before;
        }
        return spent / 1e3 / (RESETS / 2);
    }
}
