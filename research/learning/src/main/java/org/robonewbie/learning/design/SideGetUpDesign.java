package org.robonewbie.learning.design;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.learning.rehearsal.Lying;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.nao.motion.file.ShippedMotions;

/**
 * Getting up from the left side: a roll onto the back, drawn by hand, and then the shipped way to get up from there. From the
 * right side it is the mirror image.
 */
public final class SideGetUpDesign extends DrawnDesign {

    private static final String NAME = "stand-up-from-left-side";
    private static final String AFTERWARDS = "stand-up-from-back";

    /** Describes how to get up from the side. */
    public SideGetUpDesign() {}

    @Override
    List<DescribedMotion> motions() {
        Sketch roll = Sketch.load(NAME, joint -> false);
        List<Keyframe> keyframes =
                new ArrayList<>(roll.motion(roll.coordinates()).keyframes());
        keyframes.addAll(ShippedMotions.motion(AFTERWARDS).keyframes());
        var motion = new DescribedMotion(
                new Motion(NAME, keyframes), "rolls onto the back and gets up", Lying.ON_LEFT.words(), "stance");
        return List.of(motion, motion.mirrored());
    }
}
