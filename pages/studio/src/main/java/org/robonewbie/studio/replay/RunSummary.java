package org.robonewbie.studio.replay;

import com.google.gson.Gson;
import java.util.List;
import java.util.Map;

/**
 * Summary of a recording for its preview card, and the data that a page needs to open it at any cycle.
 *
 * @param count number of cycles
 * @param firstCycle simulation cycle of the first frame
 * @param left name of the left team, empty if there was none
 * @param right name of the right team, empty if there was none
 * @param score final score of the left and the right team
 * @param robots maximum number of simultaneous robots
 * @param pitch length and width of the field in metres
 * @param ball trail of the ball
 * @param ways trails of the robots
 * @param events events in chronological order
 * @param rosters line-ups, each with its number of cycles
 * @param header header of the recording
 */
record RunSummary(
        int count,
        long firstCycle,
        String left,
        String right,
        List<Integer> score,
        int robots,
        List<Double> pitch,
        List<List<Double>> ball,
        List<Way> ways,
        List<Event> events,
        List<Roster> rosters,
        Map<String, String> header) {

    /**
     * Trail of a robot.
     *
     * @param side side of its team: 0 for no team, 1 for the left team, 2 for the right team
     * @param places x and y in metres, sampled at equal intervals while the robot is present
     */
    record Way(int side, List<List<Double>> places) {}

    /**
     * An event in the recording.
     *
     * @param index zero-based index of the cycle in the recording
     * @param kind goal, foul, playmode or fall
     * @param text description from the recording
     */
    record Event(int index, String kind, String text) {}

    /**
     * Line-up of robots.
     *
     * @param robots the robots in the order of the recording
     * @param cycles number of cycles with this line-up
     */
    record Roster(List<Member> robots, int cycles) {}

    /**
     * A robot in a line-up.
     *
     * @param type body type such as {@code TYPE_0}
     * @param number player number
     * @param team name of its team
     */
    record Member(String type, int number, String team) {}

    String json() {
        return new Gson().toJson(this);
    }

    static RunSummary ofJson(String json) {
        return new Gson().fromJson(json, RunSummary.class);
    }

    /** {@return the data for the preview card, as JSON} */
    String card() {
        return new Gson()
                .toJson(new RunSummary(
                        count, firstCycle, left, right, score, robots, pitch, ball, ways, events, List.of(), Map.of()));
    }
}
