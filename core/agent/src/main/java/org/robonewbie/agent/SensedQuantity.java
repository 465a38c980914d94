package org.robonewbie.agent;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.text.Spelling;

/**
 * Something that a robot feels in each cycle, and that a policy may take, under the names that learning programs know.
 *
 * @param quantity its name and unit
 * @param reading reads it
 */
record SensedQuantity(Quantity quantity, ToDoubleFunction<Robot> reading) {

    private static final String METRES = "m";
    private static final String NEWTONS = "N";
    private static final Map<String, SensedQuantity> ALL =
            all().collect(Collectors.toMap(felt -> felt.quantity().name(), felt -> felt));

    /**
     * Looks a quantity up.
     *
     * @throws IllegalArgumentException if robots feel nothing of this name, or in another unit
     */
    static SensedQuantity of(Quantity wanted) {
        return named(wanted.name())
                .filter(felt -> felt.quantity().equals(wanted))
                .orElseThrow(() -> new IllegalArgumentException("A robot does not feel " + wanted.name() + " in "
                        + wanted.unit() + "." + advice(wanted.name())));
    }

    private static String advice(String name) {
        return named(name)
                .map(felt -> " It is felt in " + felt.quantity().unit() + ".")
                .orElseGet(() -> Spelling.question(name, ALL.keySet(), SensedQuantity::withUnit));
    }

    private static String withUnit(String name) {
        return name + named(name).map(felt -> " in " + felt.quantity().unit()).orElse("");
    }

    private static Optional<SensedQuantity> named(String name) {
        return Optional.ofNullable(ALL.get(name));
    }

    private static Stream<SensedQuantity> all() {
        return Stream.of(
                        Stream.of(Joint.values()).map(SensedQuantity::angle),
                        vector("gyro", "degrees/s", Robot::getGyro),
                        vector("accelerometer", "m/s²", Robot::getAcceleration),
                        vector(
                                "leftFoot.point",
                                METRES,
                                robot -> robot.getLeftFootPressure().point()),
                        vector(
                                "leftFoot.force",
                                NEWTONS,
                                robot -> robot.getLeftFootPressure().force()),
                        vector(
                                "rightFoot.point",
                                METRES,
                                robot -> robot.getRightFootPressure().point()),
                        vector(
                                "rightFoot.force",
                                NEWTONS,
                                robot -> robot.getRightFootPressure().force()))
                .flatMap(quantities -> quantities);
    }

    private static SensedQuantity angle(Joint joint) {
        return new SensedQuantity(new Quantity("joint." + joint, "degrees"), robot -> robot.getJointAngle(joint));
    }

    private static Stream<SensedQuantity> vector(String name, String unit, Function<Robot, Vector3> vector) {
        return List.<Map.Entry<String, ToDoubleFunction<Vector3>>>of(
                        Map.entry("forward", Vector3::x), Map.entry("left", Vector3::y), Map.entry("up", Vector3::z))
                .stream()
                .map(axis -> new SensedQuantity(
                        new Quantity(name + "." + axis.getKey(), unit),
                        robot -> axis.getValue().applyAsDouble(vector.apply(robot))));
    }
}
