package org.robonewbie.simulator.recording;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.NaoModel;

/** Puts a robot together again from the place of its torso and its joint angles. */
final class LimbPoses {

    private LimbPoses() {}

    /** Seven numbers for each link, as in a snapshot. */
    static float[] of(NaoModel model, Pose torso, float[] jointDegrees) {
        Pose[] poses = new Pose[model.links().size()];
        poses[0] = torso;
        List<Hinge> hinges = model.hinges();
        for (int i = 0; i < hinges.size(); i++) {
            Hinge hinge = hinges.get(i);
            int child = model.linkIndex(hinge.child());
            int parent = model.linkIndex(hinge.parent());
            poses[child] = attach(model, hinge, child, parent, poses[parent], jointDegrees[i]);
        }
        float[] numbers = new float[RecordingFormat.NUMBERS_PER_POSE * poses.length];
        for (int i = 0; i < poses.length; i++) {
            write(poses[i], numbers, RecordingFormat.NUMBERS_PER_POSE * i);
        }
        return numbers;
    }

    private static Pose attach(NaoModel model, Hinge hinge, int child, int parent, Pose parentPose, double degrees) {
        Vector3 anchorInParent = hinge.anchor().minus(model.links().get(parent).position());
        Vector3 childFromAnchor = model.links().get(child).position().minus(hinge.anchor());
        Pose joint = new Pose(anchorInParent, Rotation.about(hinge.axis(), degrees));
        return parentPose.times(joint).times(new Pose(childFromAnchor, Rotation.NONE));
    }

    private static void write(Pose pose, float[] numbers, int index) {
        numbers[index] = (float) pose.position().x();
        numbers[index + 1] = (float) pose.position().y();
        numbers[index + 2] = (float) pose.position().z();
        numbers[index + 3] = (float) pose.rotation().w();
        numbers[index + 4] = (float) pose.rotation().x();
        numbers[index + 5] = (float) pose.rotation().y();
        numbers[index + 6] = (float) pose.rotation().z();
    }
}
