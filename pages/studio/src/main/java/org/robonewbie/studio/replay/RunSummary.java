package org.robonewbie.studio.replay;

import com.google.gson.Gson;
import java.util.List;
import java.util.Map;

/**
 * What people want to know of a recording before they open it, and what a page needs to open it at any moment.
 *
 * @param count number of its cycles
 * @param firstCycle number of the first one since the start of the simulation
 * @param left name of the left team, empty if there was none
 * @param right name of the right team, empty if there was none
 * @param score goals of the left and of the right team at the end
 * @param robots how many robots took part at most at the same time
 * @param pitch length and width of the field in metres
 * @param ball way of the ball
 * @param ways of the robots
 * @param events what happened, the earliest first
 * @param rosters who was on the pitch, and in how many cycles
 * @param header of the recording
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
     * The way of a robot.
     *
     * @param side 0 without a team, 1 for the left team, 2 for the right one
     * @param places x and y in metres, evenly over the time in which it was there
     */
    record Way(int side, List<List<Double>> places) {}

    /**
     * Something that happened.
     *
     * @param index of the cycle in the recording
     * @param kind goal, foul, playmode or fall
     * @param text what the recording says of it
     */
    record Event(int index, String kind, String text) {}

    /**
     * Robots that were on the pitch together.
     *
     * @param robots in the order of the recording
     * @param cycles for how long
     */
    record Roster(List<Member> robots, int cycles) {}

    /**
     * A robot as pages know it.
     *
     * @param type such as {@code TYPE_0}
     * @param number on its shirt
     * @param team name of its team
     */
    record Member(String type, int number, String team) {}

    /** {@return all of it as JSON} */
    String json() {
        return new Gson().toJson(this);
    }

    static RunSummary ofJson(String json) {
        return new Gson().fromJson(json, RunSummary.class);
    }

    /** {@return what stands on its card, as JSON} */
    String card() {
        return new Gson()
                .toJson(new RunSummary(
                        count, firstCycle, left, right, score, robots, pitch, ball, ways, events, List.of(), Map.of()));
    }
}
