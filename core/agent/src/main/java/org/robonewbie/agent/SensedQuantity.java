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
 * Sensor reading that a policy may use as an input, under the name used in training.
 *
 * @param quantity name and unit
 * @param reading function that reads the value
 */
record SensedQuantity(Quantity quantity, ToDoubleFunction<Robot> reading) {

    private static final String METRES = "m";
    private static final String NEWTONS = "N";
    private static final Map<String, SensedQuantity> ALL =
            all().collect(Collectors.toMap(sensor -> sensor.quantity().name(), sensor -> sensor));

    /**
     * Looks up a quantity.
     *
     * @throws IllegalArgumentException if the robot has no such sensor, or the sensor's unit differs
     */
    static SensedQuantity of(Quantity wanted) {
        return named(wanted.name())
                .filter(sensor -> sensor.quantity().equals(wanted))
                .orElseThrow(() -> new IllegalArgumentException("The robot has no sensor " + wanted.name() + " in "
                        + wanted.unit() + "." + advice(wanted.name())));
    }

    private static String advice(String name) {
        return named(name)
                .map(sensor -> " It is measured in " + sensor.quantity().unit() + ".")
                .orElseGet(() -> Spelling.question(name, ALL.keySet(), SensedQuantity::withUnit));
    }

    private static String withUnit(String name) {
        return name
                + named(name).map(sensor -> " in " + sensor.quantity().unit()).orElse("");
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
