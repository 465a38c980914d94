package org.robonewbie.robot;

import static org.robonewbie.robot.RobotTable.ALONG_Y;
import static org.robonewbie.robot.RobotTable.X;
import static org.robonewbie.robot.RobotTable.Y;
import static org.robonewbie.robot.RobotTable.Z;
import static org.robonewbie.robot.RobotTable.at;

/**
 * The Booster T1 of the RoboCup 3D league: 24 bodies, 23 joints, 1.18 m tall.
 *
 * <p>Source of the figures: {@code resources/robots/T1/robot.xml} of rcsssmj 0.2.1, which was adapted from Booster
 * Robotics' {@code T1_serial.xml}. The stance bends the legs and holds the robot upright by position control.
 */
public final class BoosterT1 {

    /** The model. */
    public static final RobotModel MODEL = model();

    private BoosterT1() {}

    private static RobotModel model() {
        RobotTable table = new RobotTable("T1", 0.647);
        addTrunk(table);
        addHead(table);
        addLeftArm(table);
        addRightArm(table);
        addWaist(table);
        addLeftLeg(table);
        addRightLeg(table);
        return table.model();
    }

    private static void addTrunk(RobotTable table) {
        table.torso("torso")
                .mass(
                        11.7,
                        at(0.0551365, -0.00000142, 0.105062, 0.99996, 0.00001406, -0.00899532, -0.00001392),
                        0.0915404,
                        0.0767787,
                        0.0556055)
                .box(at(0.06, 0, 0.12), 0.15, 0.2, 0.3);
    }

    private static void addHead(RobotTable table) {
        table.body("H1", "torso", at(0.0625, 0, 0.243))
                .mass(
                        0.44391,
                        at(-0.000508, -0.001403, 0.057432, 0.763881, -0.0132172, 0.00173419, 0.645219),
                        0.000241549,
                        0.00022351,
                        0.000149941)
                .joint("AAHead_yaw", "q_hj1", "he1", Z, -1.57, 1.57, 7);
        table.body("H2", "H1", at(0, 0, 0.06185))
                .mass(
                        0.631019,
                        at(0.007802, 0.001262, 0.098631, 0.988453, 0.106172, -0.0745686, -0.0782786),
                        0.00203553,
                        0.00192467,
                        0.00172381)
                .joint("Head_pitch", "q_hj2", "he2", Y, -0.35, 1.22, 7)
                .sphere(at(0.01, 0, 0.11), 0.08);
    }

    private static void addLeftArm(RobotTable table) {
        table.body("AL1", "torso", at(0.0575, 0.1063, 0.219, 1, 0, 0.000440565, 0))
                .mass(
                        0.53,
                        at(-0.000677, 0.044974, 0, 0.50423, 0.495734, -0.50423, 0.495734),
                        0.001367,
                        0.00129329,
                        0.000292711)
                .joint("Left_Shoulder_Pitch", "q_laj1", "lae1", Y, -3.31, 1.22, 18);
        table.body("AL2", "AL1", at(0, 0.047, 0))
                .mass(
                        0.16,
                        at(0.003862, 0.037976, 0, 0.487991, 0.511727, -0.487991, 0.511727),
                        0.000401,
                        0.00034538,
                        0.00017662)
                .joint("Left_Shoulder_Roll", "q_laj2", "lae2", X, -1.74, 1.57, 18);
        table.body("AL3", "AL2", at(0.00025, 0.0605, 0))
                .mass(1.02, at(0, 0.085353, -0.000099, 0.70641, 0.707803, 0, 0), 0.012869, 0.012798, 0.000620953)
                .joint("Left_Elbow_Pitch", "q_laj3", "lae3", Y, -2.27, 2.27, 18)
                .capsule(at(0, 0.05, 0, ALONG_Y), 0.03, 0.15);
        table.body("left_hand_link", "AL3", at(0, 0.1471, 0))
                .mass(
                        0.327214,
                        at(-0.000108, 0.109573, 0.000591, 0.707866, 0.706347, -0.00005229, -0.000214913),
                        0.008159,
                        0.00813104,
                        0.000214962)
                .joint("Left_Elbow_Yaw", "q_laj4", "lae4", Z, -2.44, 0, 18)
                .capsule(at(0, 0.13, 0, ALONG_Y), 0.03, 0.175);
    }

    private static void addRightArm(RobotTable table) {
        table.body("AR1", "torso", at(0.0575, -0.1063, 0.219, 1, 0, 0.000440565, 0))
                .mass(
                        0.53,
                        at(-0.000677, -0.044974, 0, 0.50423, 0.495734, -0.50423, 0.495734),
                        0.001367,
                        0.00129329,
                        0.000292711)
                .joint("Right_Shoulder_Pitch", "q_raj1", "rae1", Y, -3.31, 1.22, 18);
        table.body("AR2", "AR1", at(0, -0.047, 0))
                .mass(
                        0.16,
                        at(0.003862, -0.037976, 0, 0.511727, 0.487991, -0.511727, 0.487991),
                        0.000401,
                        0.00034538,
                        0.00017662)
                .joint("Right_Shoulder_Roll", "q_raj2", "rae2", X, -1.57, 1.74, 18);
        table.body("AR3", "AR2", at(0.00025, -0.0605, 0))
                .mass(1.02, at(0, -0.085353, -0.000099, 0.707803, 0.70641, 0, 0), 0.012869, 0.012798, 0.000620953)
                .joint("Right_Elbow_Pitch", "q_raj3", "rae3", Y, -2.27, 2.27, 18)
                .capsule(at(0, -0.05, 0, ALONG_Y), 0.03, 0.15);
        table.body("right_hand_link", "AR3", at(0, -0.1471, 0))
                .mass(
                        0.327214,
                        at(-0.000108, -0.109573, 0.000591, 0.706347, 0.707866, 0.000214913, 0.00005229),
                        0.008159,
                        0.00813104,
                        0.000214962)
                .joint("Right_Elbow_Yaw", "q_raj4", "rae4", Z, 0, 2.44, 18)
                .capsule(at(0, -0.13, 0, ALONG_Y), 0.03, 0.175);
    }

    private static void addWaist(RobotTable table) {
        table.body("Waist", "torso", at(0.0625, 0, -0.1155))
                .mass(
                        2.581,
                        at(0.002284, 0.000003, 0.007301, 0.983649, 0.000360386, -0.180076, 0.00269791),
                        0.00536742,
                        0.005299,
                        0.00474258)
                .joint("Waist", "q_tj1", "te1", Z, -1.57, 1.57, 30);
    }

    private static void addLeftLeg(RobotTable table) {
        table.body("Hip_Pitch_Left", "Waist", at(0, 0.106, 0))
                .mass(
                        1.021,
                        at(0.000534, -0.007296, -0.018083, 0.975141, 0.2211, 0.0145808, 0.0017406),
                        0.00180547,
                        0.00145926,
                        0.00125327)
                .joint("Left_Hip_Pitch", "q_llj1", "lle1", Y, -1.8, 1.57, 45);
        table.body("Hip_Roll_Left", "Hip_Pitch_Left", at(0, 0, -0.02))
                .mass(
                        0.385,
                        at(0.001101, 0.000024, -0.05375, 0.707081, -0.00599604, -0.00599604, 0.707081),
                        0.001743,
                        0.00151729,
                        0.000514712)
                .joint("Left_Hip_Roll", "q_llj2", "lle2", X, -0.2, 1.57, 30)
                .capsule(at(0, 0, -0.08), 0.05, 0.16);
        table.body("Hip_Yaw_Left", "Hip_Roll_Left", at(0, 0, -0.081854))
                .mass(
                        2.166,
                        at(-0.007233, 0.000206, -0.089184, 0.696808, -0.033953, -0.0315708, 0.715758),
                        0.0257334,
                        0.0253024,
                        0.00259215)
                .joint("Left_Hip_Yaw", "q_llj3", "lle3", Z, -1, 1, 30);
        table.body("Shank_Left", "Hip_Yaw_Left", at(-0.014, 0, -0.134))
                .mass(
                        1.73,
                        at(-0.006012, 0.000259, -0.124318, 0.997573, 0.00144024, -0.023949, 0.0653706),
                        0.0346951,
                        0.0345375,
                        0.00185844)
                .joint("Left_Knee_Pitch", "q_llj4", "lle4", Y, 0, 2.34, 60)
                .capsule(at(0, 0, -0.12), 0.05, 0.15);
        table.body("Ankle_Cross_Left", "Shank_Left", at(0, 0, -0.28))
                .mass(
                        0.073,
                        at(-0.003722, 0, -0.007981, 0.443136, 0.551027, 0.551027, 0.443136),
                        0.000029,
                        0.00002566,
                        0.00001134)
                .joint("Left_Ankle_Pitch", "q_llj5", "lle5", Y, -0.87, 0.35, 20);
        table.body("left_foot_link", "Ankle_Cross_Left", at(0, 0.00025, -0.012))
                .mass(0.685, at(-0.000249, 0, -0.00914, 0, 0.679927, 0, 0.733279), 0.00268212, 0.002385, 0.000726885)
                .joint("Left_Ankle_Roll", "q_llj6", "lle6", X, -0.44, 0.44, 15)
                .box(at(0.01, 0, -0.015), 0.223, 0.1, 0.03);
    }

    private static void addRightLeg(RobotTable table) {
        table.body("Hip_Pitch_Right", "Waist", at(0, -0.106, 0))
                .mass(
                        1.021,
                        at(0.000534, 0.007514, -0.018082, 0.973446, -0.228403, 0.0147148, -0.00419349),
                        0.00180552,
                        0.0014632,
                        0.00124928)
                .joint("Right_Hip_Pitch", "q_rlj1", "rle1", Y, -1.8, 1.57, 45);
        table.body("Hip_Roll_Right", "Hip_Pitch_Right", at(0, 0, -0.02))
                .mass(
                        0.385,
                        at(0.001099, 0.000024, -0.053748, 0.707081, -0.00599604, -0.00599604, 0.707081),
                        0.001743,
                        0.00151729,
                        0.000514712)
                .joint("Right_Hip_Roll", "q_rlj2", "rle2", X, -1.57, 0.2, 30)
                .capsule(at(0, 0, -0.08), 0.05, 0.16);
        table.body("Hip_Yaw_Right", "Hip_Roll_Right", at(0, 0, -0.081854))
                .mass(
                        2.17,
                        at(-0.007191, -0.000149, -0.08922, 0.714468, -0.0315638, -0.0336391, 0.698146),
                        0.0257623,
                        0.0253298,
                        0.00259389)
                .joint("Right_Hip_Yaw", "q_rlj3", "rle3", Z, -1, 1, 30);
        table.body("Shank_Right", "Hip_Yaw_Right", at(-0.014, 0, -0.134))
                .mass(
                        1.79,
                        at(-0.005741, -0.000541, -0.122602, 0.99926, -0.000580963, -0.023461, -0.0304754),
                        0.0351717,
                        0.0349574,
                        0.00196589)
                .joint("Right_Knee_Pitch", "q_rlj4", "rle4", Y, 0, 2.34, 60)
                .capsule(at(0, 0, -0.12), 0.05, 0.15);
        table.body("Ankle_Cross_Right", "Shank_Right", at(0, 0, -0.28))
                .mass(
                        0.073,
                        at(-0.003722, 0, -0.007981, 0.443136, 0.551027, 0.551027, 0.443136),
                        0.000029,
                        0.00002566,
                        0.00001134)
                .joint("Right_Ankle_Pitch", "q_rlj5", "rle5", Y, -0.87, 0.35, 20);
        table.body("right_foot_link", "Ankle_Cross_Right", at(0, -0.00025, -0.012))
                .mass(0.685, at(-0.000248, 0, -0.00914, 0, 0.679927, 0, 0.733279), 0.00268212, 0.002385, 0.000726885)
                .joint("Right_Ankle_Roll", "q_rlj6", "rle6", X, -0.44, 0.44, 15)
                .box(at(0.01, 0, -0.015), 0.223, 0.1, 0.03);
    }
}
