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
 * How a robot came to where its recording begins: it appeared in the air, joined a team some cycles later, was beamed some
 * cycles after that, and again later the first row was written. It lands, or is even put into the ground if its legs are long,
 * on this way; so the last digits of its stance depend on it, and with them where it is at the end of a fall.
 *
 * @param cyclesToInit cycles that the world made between creating the robot and {@code init}, at least 1
 * @param place where the robot was put when it joined
 * @param cyclesToBeam cycles between the commands {@code init} and {@code beam}, at least 1
 * @param cyclesToFirstRow cycles between {@code beam} and the first row; 0 if it is not known, then the robot comes to rest
 */
record JoiningWay(int cyclesToInit, Vector3 place, int cyclesToBeam, int cyclesToFirstRow) {

    private static final Vector3 FIRST_PLACE = new StartPositions(TeamSide.LEFT, SoccerParameters.league()).next();
    private static final Vector3 FIRST_PLACE_OF_THE_RIGHT_TEAM =
            new StartPositions(TeamSide.RIGHT, SoccerParameters.league()).next();
    private static final JoiningWay SETTLED = new JoiningWay(3, FIRST_PLACE, 60, 0);
    private static final JoiningWay AT_ONCE = new JoiningWay(3, FIRST_PLACE, 2, 0);
    private static final int MOST_CYCLES = 3000;
    private static final int MOST_PLACES = 200;
    private static final double SAME_METRES = 0.002;
    private static final String FIELD = "start";
    private static final String TO_INIT = "cyclesFromSceneToInit";
    private static final String PLACE = "joinedAt";
    private static final String TO_BEAM = "cyclesFromInitToBeam";
    private static final String TO_FIRST_ROW = "cyclesFromBeamToFirstRow";

    /**
     * Returns the ways of joining that are possible.
     *
     * @param recording a recording whose header may name the way
     * @return at least one way, the likeliest first
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
        return List.of(SETTLED.at(place), AT_ONCE.at(place));
    }

    /** Without noise a robot is beamed into its own half. */
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

    /** {@return the heading of a robot that has just joined, as its rotation about the vertical: towards the other half} */
    double yawDegrees() {
        return side() == TeamSide.LEFT ? -90 : 90;
    }

    /** {@return how many places the team had given to others before; 0 if its row does not pass here} */
    int placesBefore() {
        StartPositions places = new StartPositions(side(), SoccerParameters.league());
        for (int i = 0; i < MOST_PLACES; i++) {
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

    /** Adds this way to the header of a recording. */
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

    /** The place of the league's pitch that is meant, to the last bit. */
    private static Vector3 placeNear(Vector3 printed) {
        for (TeamSide side : TeamSide.values()) {
            StartPositions places = new StartPositions(side, SoccerParameters.league());
            for (int i = 0; i < MOST_PLACES; i++) {
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
        return value != null && isNumber(value) ? Math.max(least, Math.min(MOST_CYCLES, value.getAsInt())) : least;
    }

    private static boolean isNumber(JsonElement value) {
        return value.isJsonPrimitive() && value.getAsJsonPrimitive().isNumber();
    }
}
