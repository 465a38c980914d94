package org.robonewbie.learning.design;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.robonewbie.learning.rehearsal.FallenRobot;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Motion;

/**
 * Robots of several builds that have fallen, to be tried again and again. Who learns to get up practises most with the falls that are still
 * too hard.
 */
final class PractisedFalls {

    private static final int FALLS_OF_A_TYPE = 100;
    private static final int TRIALS_OF_A_TYPE = 3;
    private static final long FIRST_FALL = 100_000;

    private final List<List<FallenRobot>> robots;
    private final List<List<FallenRobot>> hard = new ArrayList<>();
    private final Random chance;

    /** Lets robots fall: a quarter by a motion that falls on purpose, the others with their arms anywhere. */
    PractisedFalls(Lying lying, List<RobotType> types, long seed) {
        chance = new Random(seed);
        robots = types.stream().map(type -> falls(lying, type)).toList();
        hard.addAll(robots);
    }

    /**
     * Finds out which falls are hard.
     *
     * @param motion how the robots get up so far
     * @param settlingSeconds how long a robot has to stand
     * @return from how many they get up
     */
    int examine(Motion motion, double settlingSeconds) {
        hard.clear();
        for (List<FallenRobot> falls : robots) {
            hard.add(falls.stream()
                    .filter(robot -> !robot.getUp(motion, 0, 0, settlingSeconds).success())
                    .toList());
        }
        return robots.stream().mapToInt(List::size).sum()
                - hard.stream().mapToInt(List::size).sum();
    }

    /** Draws some falls of each type, two of three hard ones. */
    List<FallenRobot> draw() {
        return IntStream.range(0, robots.size())
                .boxed()
                .flatMap(type -> IntStream.range(0, TRIALS_OF_A_TYPE).mapToObj(i -> draw(type, i > 0)))
                .toList();
    }

    private FallenRobot draw(int type, boolean isHard) {
        List<FallenRobot> falls = isHard && !hard.get(type).isEmpty() ? hard.get(type) : robots.get(type);
        return falls.get(chance.nextInt(falls.size()));
    }

    private static List<FallenRobot> falls(Lying lying, RobotType type) {
        return IntStream.range(0, FALLS_OF_A_TYPE)
                .mapToObj(i -> fall(lying, type, FIRST_FALL + i, i % 4 == 3))
                .toList();
    }

    private static FallenRobot fall(Lying lying, RobotType type, long seed, boolean onPurpose) {
        if (onPurpose) {
            FallenRobot robot = FallenRobot.after(type, lying == Lying.ON_BACK ? "fall-back" : "fall-forward", seed);
            if (robot.lies(lying)) {
                return robot;
            }
        }
        return FallenRobot.anyhow(lying, type, seed);
    }
}
