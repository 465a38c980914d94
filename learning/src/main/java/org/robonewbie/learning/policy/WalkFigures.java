package org.robonewbie.learning.policy;

import java.util.Locale;
import org.robonewbie.nao.Cycle;

/** What came of lessons: what they paid, how often the robot fell, and how well it followed the velocities. */
public final class WalkFigures {

    private static final double SECONDS_OF_20_MINUTES = 1200;

    private int lessons;
    private long cycles;
    private int falls;
    private double reward;
    private int settled;
    private double error;
    private double turnError;

    /** Creates figures of no lesson. */
    WalkFigures() {}

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

    void add(WalkFigures others) {
        lessons += others.lessons;
        cycles += others.cycles;
        falls += others.falls;
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

    @Override
    public String toString() {
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
