package org.robonewbie.simulator.recording;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.simulator.json.Json;

/**
 * The ground-truth results of a run.
 *
 * @param seed seed for all random numbers
 * @param simulatedSeconds simulated duration
 * @param wallSeconds real duration
 * @param missedCycles number of 20 ms cycles by which the run fell behind real time; 0 in sync mode
 * @param robots the results for all robots
 * @param ball the results for the ball
 * @param goals all valid goals
 * @param recordingSha256 checksum of the uncompressed recording, equal for identical runs
 */
public record RunReport(
        long seed,
        double simulatedSeconds,
        double wallSeconds,
        long missedCycles,
        List<RobotResult> robots,
        Ball ball,
        List<Goal> goals,
        String recordingSha256) {

    private static final double ROUNDING = 1e6;

    /** Makes the lists unmodifiable. */
    public RunReport {
        robots = List.copyOf(robots);
        goals = List.copyOf(goals);
    }

    /**
     * The results for one robot.
     *
     * @param team name of its team
     * @param number uniform number, 0 if it has no team
     * @param falls number of times that the torso tilted by more than 60 degrees or sank below 0.2 m after the robot had been
     *     standing
     * @param metresWalked distance walked, excluding swaying and beams
     * @param position final position of the torso's centre in the world frame, metres
     * @param headingDegrees final heading, 0 along x towards the right goal, counter-clockwise
     * @param upright whether the robot was standing at the end
     * @param missedCycles number of messages to which the agent did not respond before the next one was sent
     * @param joints final angle of each joint in degrees
     */
    public record RobotResult(
            String team,
            int number,
            int falls,
            double metresWalked,
            Vector3 position,
            double headingDegrees,
            boolean upright,
            long missedCycles,
            Map<String, Double> joints) {

        /** Makes the map unmodifiable. */
        public RobotResult {
            joints = Collections.unmodifiableMap(new LinkedHashMap<>(joints));
        }
    }

    /**
     * The results for the ball.
     *
     * @param position final position of its centre in the world frame, metres
     * @param metresMoved distance that the ball rolled and flew
     * @param leastDistanceToGoal minimum distance from the mouth of the goal that the left team attacks, metres
     */
    public record Ball(Vector3 position, double metresMoved, double leastDistanceToGoal) {}

    /**
     * A valid goal.
     *
     * @param playSeconds game time in seconds
     * @param team name of the team that scored
     */
    public record Goal(double playSeconds, String team) {}

    /** {@return simulated seconds per real second} */
    public double realTimeFactor() {
        return wallSeconds == 0 ? 0 : simulatedSeconds / wallSeconds;
    }

    /**
     * Converts the report to JSON.
     *
     * @return the JSON text
     */
    public String toJson() {
        JsonObject json = Json.object(
                "seed", seed,
                "simulatedSeconds", rounded(simulatedSeconds),
                "wallSeconds", rounded(wallSeconds),
                "realTimeFactor", rounded(realTimeFactor()),
                "missedCycles", missedCycles,
                "robots", Json.array(robots.stream().map(RunReport::json)),
                "ball", json(ball),
                "goals", Json.array(goals.stream().map(RunReport::json)),
                "recordingSha256", recordingSha256);
        return new GsonBuilder()
                        .setPrettyPrinting()
                        .disableHtmlEscaping()
                        .create()
                        .toJson(json) + "\n";
    }

    /** Maps the names of all joints, such as {@code LEFT_KNEE_PITCH}, to their angles. Toe joints keep their SimSpark names. */
    static Map<String, Double> joints(RobotModel model, double[] degrees) {
        Map<String, Double> joints = new LinkedHashMap<>();
        model.joints().forEach(joint -> joints.put(joint.name(), degrees[joint.index()]));
        return joints;
    }

    private static JsonObject json(RobotResult robot) {
        JsonObject joints = new JsonObject();
        robot.joints().forEach((name, degrees) -> joints.addProperty(name, rounded(degrees)));
        return Json.object(
                "team", robot.team(),
                "number", robot.number(),
                "falls", robot.falls(),
                "metresWalked", rounded(robot.metresWalked()),
                "x", rounded(robot.position().x()),
                "y", rounded(robot.position().y()),
                "z", rounded(robot.position().z()),
                "headingDegrees", rounded(robot.headingDegrees()),
                "upright", robot.upright(),
                "missedCycles", robot.missedCycles(),
                "joints", joints);
    }

    private static JsonObject json(Ball ball) {
        return Json.object(
                "x", rounded(ball.position().x()),
                "y", rounded(ball.position().y()),
                "z", rounded(ball.position().z()),
                "metresMoved", rounded(ball.metresMoved()),
                "leastDistanceToGoal", rounded(ball.leastDistanceToGoal()));
    }

    private static JsonObject json(Goal goal) {
        return Json.object("time", rounded(goal.playSeconds()), "team", goal.team());
    }

    /** Rounds to six decimals. Infinite values, such as the distance to the goal in a run without cycles, become 0. */
    private static double rounded(double value) {
        return Double.isFinite(value) ? PortableMath.rint(value * ROUNDING) / ROUNDING : 0;
    }
}
