package org.robonewbie.nao.motion;

import org.robonewbie.nao.Joint;

/** Each joint turns at constant speed from one keyframe to the next; at the keyframes the speed changes abruptly. */
public final class LinearInterpolation implements Interpolation {

    /** Creates the interpolation; {@link Interpolation#LINEAR} is a ready-made one. */
    public LinearInterpolation() {}

    @Override
    public double degrees(KeyframeInterval section, Joint joint, double fraction) {
        double from = section.from().degrees(joint);
        double to = section.to().degrees(joint);
        return fraction >= 1 ? to : from + fraction * (to - from);
    }
}
