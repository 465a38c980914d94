package org.robonewbie.workshop.speed;

import java.util.Locale;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/** Movement of the robots during a benchmark. */
public enum CrowdScene {
    /** Standing with bent knees; every joint is controlled, so the physics never puts the robots to sleep. */
    STANDING {
        @Override
        double targetDegrees(Joint joint, int robot, int cycle) {
            return crouch(joint, 0);
        }
    },
    /** Stepping in place. */
    WALKING {
        @Override
        double targetDegrees(Joint joint, int robot, int cycle) {
            double phase = 2 * Math.PI * cycle / CYCLES_PER_STEP + robot;
            boolean left = joint.name().startsWith("LEFT");
            return crouch(joint, Math.max(0, Math.sin(left ? phase : phase + Math.PI)));
        }
    },
    /** Dropped in a pile every ten seconds, with random movements of all joints. */
    HEAP {
        @Override
        double targetDegrees(Joint joint, int robot, int cycle) {
            long random = mixed(31L * (31L * (cycle / CYCLES_PER_TARGET) + robot) + joint.ordinal());
            double share = (random >>> 11) * 0x1p-53;
            return joint.minDegrees() + share * (joint.maxDegrees() - joint.minDegrees());
        }

        @Override
        Vector3 place(int robot) {
            int row = robot / 3 % 3;
            int layer = robot / 9;
            return new Vector3(-3 + 0.3 * (robot % 3), 0.3 * row, 0.6 + 0.5 * layer);
        }

        @Override
        boolean placesAgain(int cycle) {
            return cycle % CYCLES_PER_THROW == 0;
        }
    };

    private static final int CYCLES_PER_STEP = 30;
    private static final int CYCLES_PER_TARGET = 25;
    private static final int CYCLES_PER_THROW = 500;
    private static final double CROUCH_DEGREES = 25;
    private static final double LIFT_DEGREES = 12;

    /** Returns the start position of a robot: far from the others, or in the pile. */
    Vector3 place(int robot) {
        return new Vector3(-13 + 2.5 * (robot % 11), robot < 11 ? 4 : -4, 0.39);
    }

    /** Returns whether all robots are reset to their start positions before a cycle. */
    boolean placesAgain(int cycle) {
        return cycle == 0;
    }

    /** Returns the target angle of a joint. */
    abstract double targetDegrees(Joint joint, int robot, int cycle);

    /** Returns the angle of a joint for bent knees and level soles; lifting a foot bends its knee further. */
    private static double crouch(Joint joint, double lift) {
        double bend = CROUCH_DEGREES + LIFT_DEGREES * lift;
        return switch (joint) {
            case LEFT_HIP_PITCH, RIGHT_HIP_PITCH, LEFT_FOOT_PITCH, RIGHT_FOOT_PITCH -> bend;
            case LEFT_KNEE_PITCH, RIGHT_KNEE_PITCH -> -2 * bend;
            case LEFT_SHOULDER_PITCH, RIGHT_SHOULDER_PITCH -> -90;
            default -> 0;
        };
    }

    /** Applies the mixing step of the SplitMix64 generator (Steele, Lea and Flood 2014). */
    private static long mixed(long number) {
        long z = (number + 1) * 0x9E3779B97F4A7C15L;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /** {@return the lower-case name of the scene on the command line and in the results} */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
