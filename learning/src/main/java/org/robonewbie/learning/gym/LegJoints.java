package org.robonewbie.learning.gym;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.nao.Joint;

/** The joints of both legs. */
final class LegJoints {

    static final List<Joint> ALL = Arrays.stream(Joint.values())
            .filter(joint -> joint.name().matches(".*_(HIP|KNEE|FOOT)_.*"))
            .toList();

    private LegJoints() {}
}
