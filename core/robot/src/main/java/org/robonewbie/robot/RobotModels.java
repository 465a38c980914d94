package org.robonewbie.robot;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.robonewbie.nao.model.RobotType;

/** All models that this framework ships. */
public final class RobotModels {

    private static final List<RobotModel> ALL = Stream.concat(
                    Stream.of(BoosterT1.MODEL, BoosterK1.MODEL),
                    Arrays.stream(RobotType.values()).map(NaoRobot::of))
            .toList();

    private RobotModels() {}

    /** {@return the T1, the K1 and the five NAOs} */
    public static List<RobotModel> all() {
        return ALL;
    }
}
