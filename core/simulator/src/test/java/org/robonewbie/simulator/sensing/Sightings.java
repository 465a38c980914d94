package org.robonewbie.simulator.sensing;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;

/** All that one robot at rest has seen of each thing that does not move, picture by picture, as it was printed. */
final class Sightings {

    /** What kind of thing was seen. */
    enum Kind {
        LANDMARK,
        BALL,
        OWN_ARM,
        OTHER_PLAYER,
        LINE
    }

    /** Sum of squared deviations from each thing's mean, with what it has to be divided by. */
    record Scatter(double squares, int degreesOfFreedom) {

        double sigma() {
            return Math.sqrt(squares / degreesOfFreedom);
        }

        Scatter plus(Scatter other) {
            return new Scatter(squares + other.squares, degreesOfFreedom + other.degreesOfFreedom);
        }
    }

    /** Ends of lines nearer to the edge of the picture than this many degrees may have been cut there. */
    private static final double CUT_BEYOND_DEGREES = 58;

    private static final int MIN = 10;

    private final Map<Kind, Map<String, List<PolarPosition>>> things = new TreeMap<>();

    private Sightings() {}

    /**
     * Collects what was seen.
     *
     * @param messages to one robot that does not move, with its own arms in view
     * @param team the robot's team
     * @param number its number
     */
    static Sightings of(List<PerceptorMessage> messages, String team, int number) {
        Sightings sightings = new Sightings();
        for (PerceptorMessage message : messages) {
            message.vision().ifPresent(vision -> sightings.add(vision, team, number));
        }
        return sightings;
    }

    /** Gives each thing of a kind with its sightings, at least ten of each. */
    Map<String, List<PolarPosition>> of(Kind kind) {
        Map<String, List<PolarPosition>> often = new TreeMap<>(things.getOrDefault(kind, Map.of()));
        often.values().removeIf(seen -> seen.size() < MIN);
        return often;
    }

    /** Measures how much one number scatters about its mean for each thing of a kind. */
    Scatter scatter(Kind kind, ToDoubleFunction<PolarPosition> component) {
        Scatter sum = new Scatter(0, 0);
        for (List<PolarPosition> seen : of(kind).values()) {
            double mean = mean(seen, component);
            double squares = seen.stream()
                    .mapToDouble(position -> square(component.applyAsDouble(position) - mean))
                    .sum();
            sum = sum.plus(new Scatter(squares, seen.size() - 1));
        }
        return sum;
    }

    /**
     * Measures how much the distance scatters in units of what is expected: a share of itself, and the rounding to
     * centimetres. Things so near that rounding hides the rest are left out.
     */
    Scatter distanceScatter(Kind kind, double leastMetres, double sigmaPerMetre, double rounding) {
        Scatter sum = new Scatter(0, 0);
        for (List<PolarPosition> seen : of(kind).values()) {
            double mean = mean(seen, PolarPosition::distanceMetres);
            if (mean > leastMetres) {
                double squares = seen.stream()
                        .mapToDouble(position ->
                                square((position.distanceMetres() - mean) / Math.hypot(sigmaPerMetre * mean, rounding)))
                        .sum();
                sum = sum.plus(new Scatter(squares, seen.size() - 1));
            }
        }
        return sum;
    }

    static PolarPosition mean(List<PolarPosition> seen) {
        return new PolarPosition(
                mean(seen, PolarPosition::distanceMetres),
                mean(seen, PolarPosition::horizontalDegrees),
                mean(seen, PolarPosition::verticalDegrees));
    }

    private static double mean(List<PolarPosition> seen, ToDoubleFunction<PolarPosition> component) {
        return seen.stream().mapToDouble(component).average().orElseThrow();
    }

    private static double square(double value) {
        return value * value;
    }

    private void add(Vision vision, String team, int number) {
        vision.landmarks().forEach(seen -> add(Kind.LANDMARK, seen.landmark().name(), seen.position()));
        vision.ball().ifPresent(position -> add(Kind.BALL, "ball", position));
        for (Vision.SeenPlayer player : vision.players()) {
            boolean self = player.team().equals(team) && player.number() == number;
            for (Vision.SeenBodyPart part : player.parts()) {
                add(
                        self ? Kind.OWN_ARM : Kind.OTHER_PLAYER,
                        player.team() + player.number() + part.part(),
                        part.position());
            }
        }
        for (int i = 0; i < vision.lines().size(); i++) {
            addLineEnd("start " + i, vision.lines().get(i).start());
            addLineEnd("end " + i, vision.lines().get(i).end());
        }
    }

    private void addLineEnd(String name, PolarPosition end) {
        if (Math.abs(end.horizontalDegrees()) < CUT_BEYOND_DEGREES) {
            add(Kind.LINE, name, end);
        }
    }

    private void add(Kind kind, String name, PolarPosition position) {
        things.computeIfAbsent(kind, any -> new TreeMap<>())
                .computeIfAbsent(name, any -> new ArrayList<>())
                .add(position);
    }
}
