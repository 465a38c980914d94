package org.robonewbie.simulator.recording;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.NaoModel;

/**
 * The true results of a run, as no robot can know them.
 *
 * @param seed start of all random numbers
 * @param simulatedSeconds how long the run was
 * @param wallSeconds how long it took
 * @param missedCycles cycles of 20 ms that real time had and the world had not; 0 in sync mode
 * @param robots all robots that took part
 * @param ball the ball
 * @param goals all goals that counted
 * @param recordingSha256 checksum of the uncompressed recording, equal for equal runs
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
     * The results of one robot.
     *
     * @param team name of its team
     * @param number its number, 0 without a team
     * @param falls how often it fell: its torso leant by more than 60 degrees, or sank below 0.2 m, after it had stood
     * @param metresWalked its way over the ground while upright, without swaying and without being beamed
     * @param position centre of its torso at the end in the world frame, metres
     * @param headingDegrees where it looked at the end, 0 along x to the right goal, counter-clockwise
     * @param upright whether it stood at the end
     * @param missedCycles messages that its agent did not answer before the next one was sent
     * @param joints angle of each joint at the end in degrees
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
     * The results of the ball.
     *
     * @param position its centre at the end in the world frame, metres
     * @param metresMoved the way that it rolled and flew over the ground
     * @param leastDistanceToGoal how near it came to the mouth of the goal that the left team attacks, metres
     */
    public record Ball(Vector3 position, double metresMoved, double leastDistanceToGoal) {}

    /**
     * A goal that counted.
     *
     * @param playSeconds time of play
     * @param team name of the team that scored
     */
    public record Goal(double playSeconds, String team) {}

    /** {@return the speed of the simulation: simulated seconds per second} */
    public double realTimeFactor() {
        return wallSeconds == 0 ? 0 : simulatedSeconds / wallSeconds;
    }

    /**
     * Writes the report as text.
     *
     * @return JSON
     */
    public String toJson() {
        JsonObject json = new JsonObject();
        json.addProperty("seed", seed);
        json.addProperty("simulatedSeconds", rounded(simulatedSeconds));
        json.addProperty("wallSeconds", rounded(wallSeconds));
        json.addProperty("realTimeFactor", rounded(realTimeFactor()));
        json.addProperty("missedCycles", missedCycles);
        json.add("robots", array(robots.stream().map(RunReport::json).toList()));
        json.add("ball", json(ball));
        json.add("goals", array(goals.stream().map(RunReport::json).toList()));
        json.addProperty("recordingSha256", recordingSha256);
        return new GsonBuilder()
                        .setPrettyPrinting()
                        .disableHtmlEscaping()
                        .create()
                        .toJson(json) + "\n";
    }

    /** Maps the angles of all hinges to their names: {@code LEFT_KNEE_PITCH} and so on, toes by SimSpark's name. */
    static Map<String, Double> joints(NaoModel model, double[] degrees) {
        Map<String, Double> joints = new LinkedHashMap<>();
        List<Hinge> hinges = model.hinges();
        for (int i = 0; i < hinges.size(); i++) {
            joints.put(hinges.get(i).jointName(), degrees[i]);
        }
        return joints;
    }

    private static JsonObject json(RobotResult robot) {
        JsonObject json = new JsonObject();
        json.addProperty("team", robot.team());
        json.addProperty("number", robot.number());
        json.addProperty("falls", robot.falls());
        json.addProperty("metresWalked", rounded(robot.metresWalked()));
        json.addProperty("x", rounded(robot.position().x()));
        json.addProperty("y", rounded(robot.position().y()));
        json.addProperty("z", rounded(robot.position().z()));
        json.addProperty("headingDegrees", rounded(robot.headingDegrees()));
        json.addProperty("upright", robot.upright());
        json.addProperty("missedCycles", robot.missedCycles());
        JsonObject joints = new JsonObject();
        robot.joints().forEach((name, degrees) -> joints.addProperty(name, rounded(degrees)));
        json.add("joints", joints);
        return json;
    }

    private static JsonObject json(Ball ball) {
        JsonObject json = new JsonObject();
        json.addProperty("x", rounded(ball.position().x()));
        json.addProperty("y", rounded(ball.position().y()));
        json.addProperty("z", rounded(ball.position().z()));
        json.addProperty("metresMoved", rounded(ball.metresMoved()));
        json.addProperty("leastDistanceToGoal", rounded(ball.leastDistanceToGoal()));
        return json;
    }

    private static JsonObject json(Goal goal) {
        JsonObject json = new JsonObject();
        json.addProperty("time", rounded(goal.playSeconds()));
        json.addProperty("team", goal.team());
        return json;
    }

    private static JsonArray array(List<JsonObject> objects) {
        JsonArray array = new JsonArray();
        objects.forEach(array::add);
        return array;
    }

    /** Six decimals are enough; what is not finite, such as a distance of a run without cycles, becomes 0. */
    private static double rounded(double value) {
        return Double.isFinite(value) ? PortableMath.rint(value * ROUNDING) / ROUNDING : 0;
    }
}
