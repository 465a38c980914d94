package org.robonewbie.learning.dataset;

import com.google.gson.Gson;
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
 * Columns for the ball, landmarks and players in the camera image, and for messages that a robot receives and sends. Lists of players and
 * messages are stored as JSON, because their length varies.
 */
final class SeenAndSaid {

    private static final Gson GSON = new Gson();
    private static final PolarPosition UNSEEN = new PolarPosition(Double.NaN, Double.NaN, Double.NaN);

    private SeenAndSaid() {}

    static void addColumns(List<Column> all) {
        addPosition(all, "ball");
        for (Landmark landmark : Landmark.values()) {
            addPosition(all, landmark.name().toLowerCase(Locale.ROOT));
        }
        all.add(Column.text(
                "players", "JSON: team, number; distance (m), horizontal, vertical (degrees) of each part"));
        all.add(Column.text("heard", "JSON: team, direction (degrees to the left; none for its own messages), text"));
        all.add(Column.text("said", "the message that the agent sends in this cycle"));
    }

    private static void addPosition(List<Column> all, String name) {
        all.add(Column.decimal(name + "_distance", "m", "distance"));
        all.add(Column.decimal(name + "_horizontal", "degrees", "direction to the left"));
        all.add(Column.decimal(name + "_vertical", "degrees", "direction upwards"));
    }

    static void put(List<Object> row, PerceptorMessage message, String said) {
        row.addAll(numbers(message.vision().flatMap(Vision::ball).orElse(UNSEEN)));
        for (Landmark landmark : Landmark.values()) {
            row.addAll(numbers(message.vision()
                    .flatMap(picture -> position(picture, landmark))
                    .orElse(UNSEEN)));
        }
        row.add(message.vision().map(picture -> players(picture.players())).orElse(""));
        row.add(message.heard().isEmpty() ? "" : heard(message.heard()));
        row.add(said);
    }

    private static Optional<PolarPosition> position(Vision picture, Landmark landmark) {
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
                    .forEach(part -> one.add(
                            part.part().name().toLowerCase(Locale.ROOT), GSON.toJsonTree(numbers(part.position()))));
            player.position().ifPresent(position -> one.add("robot", GSON.toJsonTree(numbers(position))));
            all.add(one);
        }
        return all.toString();
    }

    private static List<Double> numbers(PolarPosition position) {
        return List.of(position.distanceMetres(), position.horizontalDegrees(), position.verticalDegrees());
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
