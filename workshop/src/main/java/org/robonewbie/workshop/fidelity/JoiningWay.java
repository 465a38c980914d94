package org.robonewbie.workshop.fidelity;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.List;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.simulator.soccer.StartPositions;

/**
 * Sequence of events before the recording of a robot: it was created in the air, joined a team several cycles later,
 * and was then beamed; the first row was recorded some time after that. Meanwhile, the robot landed or, if its legs are
 * long, sank into the ground. The last digits of its joint angles at rest depend on this sequence, and so does the
 * outcome of a fall.
 *
 * @param cyclesToInit cycles between creating the robot and {@code init}, at least 1
 * @param place position of the robot when it joined
 * @param cyclesToBeam cycles between the commands {@code init} and {@code beam}, at least 1
 * @param cyclesToFirstRow cycles between {@code beam} and the first row; 0 if unknown, in which case the robot first
 *     comes to rest
 */
record JoiningWay(int cyclesToInit, Vector3 place, int cyclesToBeam, int cyclesToFirstRow) {

    private static final Vector3 FIRST_PLACE = new StartPositions(TeamSide.LEFT, SoccerParameters.league()).next();
    private static final Vector3 FIRST_PLACE_OF_THE_RIGHT_TEAM =
            new StartPositions(TeamSide.RIGHT, SoccerParameters.league()).next();
    private static final JoiningWay SETTLED = new JoiningWay(3, FIRST_PLACE, 60, 0);
    private static final JoiningWay IMMEDIATE = new JoiningWay(3, FIRST_PLACE, 2, 0);
    private static final int MAX_CYCLES = 3000;
    private static final int MAX_PLACES = 200;
    private static final double SAME_METRES = 0.002;
    private static final String FIELD = "start";
    private static final String TO_INIT = "cyclesFromSceneToInit";
    private static final String PLACE = "joinedAt";
    private static final String TO_BEAM = "cyclesFromInitToBeam";
    private static final String TO_FIRST_ROW = "cyclesFromBeamToFirstRow";

    /**
     * Returns the possible sequences.
     *
     * @param recording a recording whose header may define the sequence
     * @return at least one sequence, the most likely first
     */
    static List<JoiningWay> candidates(Recording recording) {
        if (!recording.header().isEmpty()) {
            JsonElement header = JsonParser.parseString(recording.header());
            JsonElement start = header.isJsonObject() ? header.getAsJsonObject().get(FIELD) : null;
            if (start != null && start.isJsonObject()) {
                return List.of(read(start.getAsJsonObject()));
            }
        }
        Vector3 place = startsInTheRightHalf(recording) ? FIRST_PLACE_OF_THE_RIGHT_TEAM : FIRST_PLACE;
        return List.of(SETTLED.at(place), IMMEDIATE.at(place));
    }

    /**
     * Returns whether, according to the first row, the robot plays in the right half: a robot is beamed into its own
     * half.
     */
    private static boolean startsInTheRightHalf(Recording recording) {
        return recording.runs().get(0).rows().get(0).torso().stream()
                .anyMatch(torso -> torso.position().x() > 0);
    }

    private JoiningWay at(Vector3 otherPlace) {
        return new JoiningWay(cyclesToInit, otherPlace, cyclesToBeam, cyclesToFirstRow);
    }

    /** {@return the half in which the robot joined} */
    TeamSide side() {
        return place.x() > 0 ? TeamSide.RIGHT : TeamSide.LEFT;
    }

    /** {@return the rotation about the vertical axis of a robot that has just joined and is facing the opponent's half} */
    double yawDegrees() {
        return side() == TeamSide.LEFT ? -90 : 90;
    }

    /**
     * {@return the number of start positions that the team had used before; 0 if the robot's position is not a start
     * position}
     */
    int placesBefore() {
        StartPositions places = new StartPositions(side(), SoccerParameters.league());
        for (int i = 0; i < MAX_PLACES; i++) {
            if (places.next().distanceTo(place) < SAME_METRES) {
                return i;
            }
        }
        return 0;
    }

    private static JoiningWay read(JsonObject start) {
        return new JoiningWay(
                cycles(start, TO_INIT, 1), place(start), cycles(start, TO_BEAM, 1), cycles(start, TO_FIRST_ROW, 0));
    }

    /** Writes this sequence to the header of a recording. */
    void addTo(JsonObject header) {
        JsonObject start = new JsonObject();
        start.addProperty(TO_INIT, cyclesToInit);
        JsonArray joinedAt = new JsonArray();
        joinedAt.add(place.x());
        joinedAt.add(place.y());
        start.add(PLACE, joinedAt);
        start.addProperty(TO_BEAM, cyclesToBeam);
        start.addProperty(TO_FIRST_ROW, cyclesToFirstRow);
        header.add(FIELD, start);
    }

    private static Vector3 place(JsonObject start) {
        JsonElement place = start.get(PLACE);
        if (place == null || !place.isJsonArray() || place.getAsJsonArray().size() < 2) {
            return FIRST_PLACE;
        }
        JsonElement x = place.getAsJsonArray().get(0);
        JsonElement y = place.getAsJsonArray().get(1);
        return isNumber(x) && isNumber(y)
                ? placeNear(new Vector3(x.getAsDouble(), y.getAsDouble(), RecordedCommands.BEAM_HEIGHT))
                : FIRST_PLACE;
    }

    /** Returns the exact start position on the league pitch that matches a rounded start position in a recording. */
    private static Vector3 placeNear(Vector3 printed) {
        for (TeamSide side : TeamSide.values()) {
            StartPositions places = new StartPositions(side, SoccerParameters.league());
            for (int i = 0; i < MAX_PLACES; i++) {
                Vector3 place = places.next();
                if (place.distanceTo(printed) < SAME_METRES) {
                    return place;
                }
            }
        }
        return printed;
    }

    private static int cycles(JsonObject start, String name, int least) {
        JsonElement value = start.get(name);
        return value != null && isNumber(value) ? Math.max(least, Math.min(MAX_CYCLES, value.getAsInt())) : least;
    }

    private static boolean isNumber(JsonElement value) {
        return value.isJsonPrimitive() && value.getAsJsonPrimitive().isNumber();
    }
}
