package org.robonewbie.robot;

import static org.robonewbie.robot.RobotTable.ALONG_X;
import static org.robonewbie.robot.RobotTable.ALONG_Y;
import static org.robonewbie.robot.RobotTable.X;
import static org.robonewbie.robot.RobotTable.Y;
import static org.robonewbie.robot.RobotTable.Z;
import static org.robonewbie.robot.RobotTable.at;

/**
 * The Booster K1 of the RoboCup 3D league: 23 bodies, 22 joints.
 *
 * <p>Source of the figures: {@code resources/robots/K1/robot.xml} of rcsssmj 0.2.1, which was adapted from Booster
 * Robotics' {@code K1_22dof.xml}. Spheres and capsules of our own stand for its meshes and cylinders.
 */
public final class BoosterK1 {

    /** The model. */
    public static final RobotModel MODEL = model();

    private BoosterK1() {}

    private static RobotModel model() {
        RobotTable table = new RobotTable("K1", 0.526);
        addTrunk(table);
        addHead(table);
        addLeftArm(table);
        addRightArm(table);
        addLeftLeg(table);
        addRightLeg(table);
        return table.model();
    }

    private static void addTrunk(RobotTable table) {
        table.torso("torso")
                .mass(
                        6.5,
                        at(-0.0043392, -0.00065534, 0.065686, 0.999896, -0.00411546, 0.0137413, -0.00168959),
                        0.0962166,
                        0.0895166,
                        0.0201248)
                .box(at(0, 0, 0.1), 0.12, 0.16, 0.2)
                .sphere(at(0, 0, -0.06), 0.05);
    }

    private static void addHead(RobotTable table) {
        table.body("Head_1", "torso", at(0.0056, 0, 0.2149))
                .mass(
                        0.3,
                        at(-0.00069503, -0.00038527, 0.031688, 0.993827, -0.00957801, 0.00894723, -0.110168),
                        0.000429546,
                        0.000420659,
                        0.000125795)
                .joint("AAHead_yaw", "q_hj1", "he1", Z, -1, 1, 6)
                .capsule(at(0, 0, 0.01), 0.03, 0.03);
        table.body("Head_2", "Head_1", at(0, 0, 0.033))
                .mass(
                        0.7,
                        at(0.011042, -0.00092871, 0.080698, 0.996402, -0.00118413, -0.0779414, -0.0332651),
                        0.00603249,
                        0.00577511,
                        0.0017024)
                .joint("Head_pitch", "q_hj2", "he2", Y, -0.349, 0.855, 6)
                .sphere(at(0.01, 0, 0.08), 0.08);
    }

    private static void addLeftArm(RobotTable table) {
        table.body("Left_Arm_1", "torso", at(0, 0.077, 0.1845))
                .mass(
                        0.5,
                        at(-0.002701, 0.062383, -0.011965, 0.578658, 0.689818, -0.347436, 0.261905),
                        0.00223871,
                        0.00217107,
                        0.000254225)
                .joint("ALeft_Shoulder_Pitch", "q_laj1", "lae1", Y, -3.316, 1.22, 14);
        table.body("Left_Arm_2", "Left_Arm_1", at(0.0025, 0.068, -0.0135))
                .mass(
                        0.09,
                        at(0.01729, 0.018221, -0.00004329, 0.413453, 0.573635, -0.413453, 0.573635),
                        0.000113,
                        0.000095,
                        0.000065)
                .joint("Left_Shoulder_Roll", "q_laj2", "lae2", X, -1.74, 1.57, 14)
                .sphere(at(-0.007, 0, 0), 0.035);
        table.body("Left_Arm_3", "Left_Arm_2", at(0, 0.044428, 0))
                .mass(
                        0.8,
                        at(-0.0003979, 0.072617, -0.00066218, 0.679502, 0.689551, 0.177403, -0.176989),
                        0.00606947,
                        0.00606767,
                        0.000385851)
                .joint("Left_Elbow_Pitch", "q_laj3", "lae3", Y, -2.27, 2.27, 14)
                .capsule(at(0, 0.06, 0, ALONG_Y), 0.03, 0.07);
        table.body("left_hand_link", "Left_Arm_3", at(0, 0.1215, 0))
                .mass(
                        0.19,
                        at(-0.0015751, 0.084637, 0.0087033, 0.712106, 0.700961, 0.0264125, -0.0293496),
                        0.00205619,
                        0.00202933,
                        0.00008148)
                .joint("Left_Elbow_Yaw", "q_laj4", "lae4", Z, -2.44, 0, 14)
                .capsule(at(0, 0.09, 0.005, ALONG_Y), 0.025, 0.12);
    }

    private static void addRightArm(RobotTable table) {
        table.body("Right_Arm_1", "torso", at(0, -0.077, 0.1845))
                .mass(
                        0.5,
                        at(-0.0026302, -0.06251, -0.01199, 0.689302, 0.577958, -0.263425, 0.348475),
                        0.00224439,
                        0.00217742,
                        0.000255199)
                .joint("ARight_Shoulder_Pitch", "q_raj1", "rae1", Y, -3.316, 1.22, 14);
        table.body("Right_Arm_2", "Right_Arm_1", at(0.0025, -0.068, -0.0135))
                .mass(
                        0.09,
                        at(0.017229, -0.018428, 0.00004378, 0.573635, 0.413453, -0.573635, 0.413453),
                        0.000113,
                        0.000095,
                        0.000065)
                .joint("Right_Shoulder_Roll", "q_raj2", "rae2", X, -1.57, 1.74, 14)
                .sphere(at(-0.007, 0, 0), 0.035);
        table.body("Right_Arm_3", "Right_Arm_2", at(0, -0.044428, 0))
                .mass(
                        0.8,
                        at(-0.00039919, -0.072601, -0.00065629, 0.689551, 0.679502, 0.176989, -0.177403),
                        0.00607047,
                        0.00606867,
                        0.000386851)
                .joint("Right_Elbow_Pitch", "q_raj3", "rae3", Y, -2.27, 2.27, 14)
                .capsule(at(0, -0.06, 0, ALONG_Y), 0.03, 0.07);
        table.body("right_hand_link", "Right_Arm_3", at(0, -0.1215, 0))
                .mass(
                        0.19,
                        at(-0.0015177, -0.084536, 0.0086733, 0.700925, 0.712091, 0.0296562, -0.0274245),
                        0.00205618,
                        0.00203032,
                        0.00008149)
                .joint("Right_Elbow_Yaw", "q_raj4", "rae4", Z, 0, 2.44, 14)
                .capsule(at(0, -0.09, 0.005, ALONG_Y), 0.025, 0.12);
    }

    private static void addLeftLeg(RobotTable table) {
        table.body("Left_Hip_Pitch", "torso", at(0, 0.096, -0.077))
                .mass(
                        0.69,
                        at(-0.010093, -0.0019934, -0.024713, 0.704206, -0.178798, -0.198986, 0.65767),
                        0.000987585,
                        0.000880963,
                        0.000503452)
                .joint("Left_Hip_Pitch", "q_llj1", "lle1", Y, -3, 2.21, 30);
        table.body("Left_Hip_Roll", "Left_Hip_Pitch", at(0, 0, -0.026))
                .mass(
                        0.13,
                        at(0.023585, 0.000049, -0.024996, 0.677218, 0.203412, 0.203412, 0.677218),
                        0.000262,
                        0.000222694,
                        0.000118306)
                .joint("Left_Hip_Roll", "q_llj2", "lle2", X, -0.4, 1.57, 35)
                .capsule(at(0, 0, 0, ALONG_X), 0.036, 0.022);
        table.body("Left_Hip_Yaw", "Left_Hip_Roll", at(0.012, 0, -0.0485))
                .mass(
                        1.65,
                        at(-0.0084744, -0.0040494, -0.087906, 0.857995, -0.00590801, -0.0582713, 0.510308),
                        0.0162716,
                        0.0158564,
                        0.00134895)
                .joint("Left_Hip_Yaw", "q_llj3", "lle3", Z, -1, 1, 20)
                .sphere(at(0, 0, -0.03), 0.04);
        table.body("Left_Shank", "Left_Hip_Yaw", at(-0.014, 0, -0.117))
                .mass(
                        1.5,
                        at(-0.00081083, 0.0031459, -0.10922, 0.940563, -0.00388906, -0.00385774, 0.339574),
                        0.0237114,
                        0.0236423,
                        0.00123731)
                .joint("Left_Knee_Pitch", "q_llj4", "lle4", Y, 0, 2.23, 40)
                .sphere(at(0, 0, 0), 0.045)
                .box(at(0, 0, -0.13), 0.06, 0.06, 0.1);
        table.body("Left_Ankle_Cross", "Left_Shank", at(0.00019706, 0.0002, -0.24519))
                .mass(0.039, at(0, 0, 0, 0.5, 0.5, 0.5, 0.5), 0.000004, 0.000004, 0.000002)
                .joint("Left_Ankle_Pitch", "q_llj5", "lle5", Y, -0.87, 0.345, 20);
        table.body("left_foot_link", "Left_Ankle_Cross", at(0, 0, 0))
                .mass(
                        0.494,
                        at(0.011662, 0.000244, -0.014364, -0.00144487, 0.663983, -0.00148176, 0.747745),
                        0.0012267,
                        0.00117,
                        0.000247305)
                .joint("Left_Ankle_Roll", "q_llj6", "lle6", X, -0.345, 0.345, 20)
                .box(at(0.026, 0, -0.02), 0.18, 0.07, 0.036);
    }

    private static void addRightLeg(RobotTable table) {
        table.body("Right_Hip_Pitch", "torso", at(0, -0.096, -0.077))
                .mass(
                        0.69,
                        at(-0.010065, 0.0020086, -0.024739, 0.656712, -0.199052, -0.176963, 0.705544),
                        0.000988671,
                        0.000880749,
                        0.00050458)
                .joint("Right_Hip_Pitch", "q_rlj1", "rle1", Y, -3, 2.21, 30);
        table.body("Right_Hip_Roll", "Right_Hip_Pitch", at(0, 0, -0.026))
                .mass(
                        0.13,
                        at(0.023585, 0.000049, -0.024996, 0.677218, 0.203412, 0.203412, 0.677218),
                        0.000262,
                        0.000222694,
                        0.000118306)
                .joint("Right_Hip_Roll", "q_rlj2", "rle2", X, -1.57, 0.4, 35)
                .capsule(at(0, 0, 0, ALONG_X), 0.036, 0.022);
        table.body("Right_Hip_Yaw", "Right_Hip_Roll", at(0.012, 0, -0.0485))
                .mass(
                        1.65,
                        at(-0.008475, 0.0040392, -0.087906, 0.510308, -0.0582713, -0.00590801, 0.857995),
                        0.0162716,
                        0.0158564,
                        0.00134895)
                .joint("Right_Hip_Yaw", "q_rlj3", "rle3", Z, -1, 1, 20)
                .sphere(at(0, 0, -0.03), 0.04);
        table.body("Right_Shank", "Right_Hip_Yaw", at(-0.014, 0, -0.117))
                .mass(
                        1.5,
                        at(-0.000805, -0.003146, -0.109215, 0.940537, 0.00388176, -0.00383651, -0.339646),
                        0.0237114,
                        0.0236423,
                        0.00123733)
                .joint("Right_Knee_Pitch", "q_rlj4", "rle4", Y, 0, 2.23, 40)
                .sphere(at(0, 0, 0), 0.045)
                .box(at(0, 0, -0.13), 0.06, 0.06, 0.1);
        table.body("Right_Ankle_Cross", "Right_Shank", at(0.00019706, -0.0002, -0.24519))
                .mass(0.039, at(0, 0, 0, 0.5, 0.5, 0.5, 0.5), 0.000004, 0.000004, 0.000002)
                .joint("Right_Ankle_Pitch", "q_rlj5", "rle5", Y, -0.87, 0.345, 20);
        table.body("right_foot_link", "Right_Ankle_Cross", at(0, 0, 0))
                .mass(
                        0.494,
                        at(0.011662, -0.000244, -0.014364, 0.00144487, 0.663983, 0.00148176, 0.747745),
                        0.0012267,
                        0.00117,
                        0.000247305)
                .joint("Right_Ankle_Roll", "q_rlj6", "rle6", X, -0.345, 0.345, 20)
                .box(at(0.026, 0, -0.02), 0.18, 0.07, 0.036);
    }
}
