package org.robonewbie.learning.dataset;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.Landmark;
import org.robonewbie.protocol.perceptor.Heard;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;

/**
 * Columns for what the camera shows besides the ball, and for what the robot hears and says. Landmarks have columns of their own;
 * players and words, of which there may be any number, are JSON.
 */
final class SeenAndSaid {

    private SeenAndSaid() {}

    static void addColumns(List<Column> all) {
        for (Landmark landmark : Landmark.values()) {
            String name = landmark.name().toLowerCase(Locale.ROOT);
            all.add(Column.decimal(name + "_distance", "m", "where the picture shows it; empty if it does not"));
            all.add(Column.decimal(name + "_horizontal", "degrees", "its direction in the picture, left is positive"));
            all.add(Column.decimal(name + "_vertical", "degrees", "its direction in the picture, up is positive"));
        }
        all.add(
                Column.text(
                        "players",
                        "players in the picture as JSON: team, number, and distance (m), horizontal, vertical (degrees) of each part"));
        all.add(
                Column.text(
                        "heard",
                        "what the robot hears as JSON: team, direction (degrees, left is positive; none for its own words) and text"));
        all.add(Column.text("said", "what the robot's program says in this cycle"));
    }

    static void put(List<Object> row, PerceptorMessage message, String said) {
        for (Landmark landmark : Landmark.values()) {
            Optional<PolarPosition> place = message.vision().flatMap(picture -> place(picture, landmark));
            row.add(place.map(PolarPosition::distanceMetres).orElse(Double.NaN));
            row.add(place.map(PolarPosition::horizontalDegrees).orElse(Double.NaN));
            row.add(place.map(PolarPosition::verticalDegrees).orElse(Double.NaN));
        }
        row.add(message.vision().map(picture -> players(picture.players())).orElse(""));
        row.add(message.heard().isEmpty() ? "" : heard(message.heard()));
        row.add(said);
    }

    private static Optional<PolarPosition> place(Vision picture, Landmark landmark) {
        return picture.landmarks().stream()
                .filter(seen -> seen.landmark() == landmark)
                .map(Vision.SeenLandmark::position)
                .findFirst();
    }

    private static String players(List<Vision.SeenPlayer> players) {
        JsonArray all = new JsonArray();
        for (Vision.SeenPlayer player : players) {
            JsonObject one = new JsonObject();
            one.addProperty("team", player.team());
            one.addProperty("number", player.number());
            player.parts()
                    .forEach(part -> one.add(part.part().name().toLowerCase(Locale.ROOT), place(part.position())));
            player.position().ifPresent(position -> one.add("robot", place(position)));
            all.add(one);
        }
        return all.toString();
    }

    private static JsonArray place(PolarPosition position) {
        JsonArray place = new JsonArray();
        place.add(position.distanceMetres());
        place.add(position.horizontalDegrees());
        place.add(position.verticalDegrees());
        return place;
    }

    private static String heard(List<Heard> messages) {
        JsonArray all = new JsonArray();
        for (Heard message : messages) {
            JsonObject one = new JsonObject();
            message.team().ifPresent(team -> one.addProperty("team", team));
            message.directionDegrees().ifPresent(degrees -> one.addProperty("direction", degrees));
            one.addProperty("text", message.text());
            all.add(one);
        }
        return all.toString();
    }
}
