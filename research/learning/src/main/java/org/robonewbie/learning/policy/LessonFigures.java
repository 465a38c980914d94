package org.robonewbie.learning.policy;

import java.util.Locale;
import org.robonewbie.nao.Cycle;

/**
 * What came of lessons: what they paid, how often the robot fell, and how well it followed the velocities or how often it did what it
 * was to do.
 */
public final class LessonFigures {

    private static final double SECONDS_OF_20_MINUTES = 1200;

    private int lessons;
    private long cycles;
    private int falls;
    private int done;
    private boolean hasAim;
    private double reward;
    private int settled;
    private double error;
    private double turnError;

    /** Creates figures of no lesson. */
    public LessonFigures() {}

    /**
     * Creates the figures of one lesson with an aim.
     *
     * @param cycles how long it was
     * @param reward what it paid
     * @param fallen whether the robot fell
     * @param reached whether the robot did what it was to do
     * @return the figures
     */
    public static LessonFigures of(int cycles, double reward, boolean fallen, boolean reached) {
        LessonFigures one = new LessonFigures();
        one.end(cycles);
        one.hasAim = true;
        one.reward = reward;
        one.falls = fallen ? 1 : 0;
        one.done = reached ? 1 : 0;
        return one;
    }

    void window(double paid) {
        reward += paid;
    }

    void settled(double metresPerSecond, double degreesPerSecond) {
        settled++;
        error += metresPerSecond;
        turnError += degreesPerSecond;
    }

    void fall(int after, double cost) {
        falls++;
        reward -= cost;
        end(after);
    }

    void end(int after) {
        lessons++;
        cycles += after;
    }

    void add(LessonFigures others) {
        lessons += others.lessons;
        cycles += others.cycles;
        falls += others.falls;
        done += others.done;
        hasAim |= others.hasAim;
        reward += others.reward;
        settled += others.settled;
        error += others.error;
        turnError += others.turnError;
    }

    /** {@return what a lesson paid on average} */
    public double reward() {
        return reward / lessons;
    }

    /** {@return how often the robot fell} */
    public int falls() {
        return falls;
    }

    /** {@return how many lessons there were} */
    public int lessons() {
        return lessons;
    }

    /** {@return in how many lessons the robot did what it was to do} */
    public int done() {
        return done;
    }

    /** {@return simulated seconds} */
    public double seconds() {
        return cycles * Cycle.SECONDS;
    }

    /** {@return falls in 20 minutes of walking} */
    public double fallsIn20Minutes() {
        return falls * SECONDS_OF_20_MINUTES / seconds();
    }

    /** {@return how much the velocity differs from the wanted one 1.2 s after a command and later, metres per second} */
    public double error() {
        return error / settled;
    }

    /** {@return how much the turning speed differs from the wanted one 1.2 s after a command and later, degrees per second} */
    public double turnError() {
        return turnError / settled;
    }

    /** {@return the head of a table of figures, as CSV without line end} */
    static String columns() {
        return "lessons,cycles,reward,falls,speedError,turnError,done";
    }

    /** {@return these figures as a line of the table; cells without meaning are empty} */
    String row() {
        String errors = settled == 0 ? "," : String.format(Locale.ROOT, "%.4f,%.3f", error(), turnError());
        return String.format(
                Locale.ROOT, "%d,%d,%.4f,%d,%s,%s", lessons, cycles, reward(), falls, errors, hasAim ? done : "");
    }

    @Override
    public String toString() {
        return hasAim
                ? String.format(
                        Locale.ROOT,
                        "done %d of %d, %d falls, reward %.3f in %.2f s on average",
                        done,
                        lessons,
                        falls,
                        reward(),
                        seconds() / lessons)
                : ofWalk();
    }

    private String ofWalk() {
        String errors = settled == 0
                ? "too short for errors"
                : String.format(Locale.ROOT, "error %.3f m/s and %.1f degrees/s", error(), turnError());
        return String.format(
                Locale.ROOT,
                "%d falls in %.1f min (%.2f in 20 min), %s, reward %.2f",
                falls,
                seconds() / 60,
                fallsIn20Minutes(),
                errors,
                reward());
    }
}
