package org.robonewbie.agent.cycle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.perception.CameraPicture;
import org.robonewbie.agent.perception.CameraPicture.Sighting;
import org.robonewbie.agent.perception.CameraPicture.Truth;
import org.robonewbie.agent.perception.Direction;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;

/** Converts vision messages to the {@link CameraPicture}s of the public API. */
final class Pictures {

    private Pictures() {}

    static CameraPicture of(Vision vision) {
        List<Sighting> sightings = new ArrayList<>();
        vision.ball().ifPresent(place -> sightings.add(sighting("ball", place)));
        vision.landmarks()
                .forEach(seen -> sightings.add(sighting(seen.landmark().name(), seen.position())));
        vision.markings().forEach(seen -> sightings.add(sighting(seen.marking().name(), seen.position())));
        vision.players().forEach(player -> addPlayer(player, sightings));
        for (SeenLine line : vision.lines()) {
            sightings.add(sighting("end of a line", line.start()));
            sightings.add(sighting("end of a line", line.end()));
        }
        return new CameraPicture(sightings, truth(vision));
    }

    private static void addPlayer(SeenPlayer player, List<Sighting> sightings) {
        String name = player.team() + " " + player.number();
        player.parts().forEach(part -> sightings.add(sighting(name + " " + part.part(), part.position())));
        player.position().ifPresent(place -> sightings.add(sighting(name, place)));
    }

    private static Optional<Truth> truth(Vision vision) {
        boolean complete = vision.ownPosition().isPresent()
                && vision.ownOrientationDegrees().isPresent()
                && vision.ballPosition().isPresent();
        return complete
                ? Optional.of(new Truth(
                        vision.ownPosition().get(),
                        vision.ownOrientationDegrees().getAsDouble(),
                        vision.ballPosition().get()))
                : Optional.empty();
    }

    private static Sighting sighting(String name, PolarPosition place) {
        return new Sighting(
                name, new Direction(place.distanceMetres(), place.horizontalDegrees(), place.verticalDegrees()));
    }
}
