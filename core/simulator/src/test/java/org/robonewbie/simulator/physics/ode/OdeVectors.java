package org.robonewbie.simulator.physics.ode;

import org.ode4j.math.DMatrix3;
import org.ode4j.math.DMatrix3C;
import org.ode4j.math.DVector3C;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.RotationMatrix;

/** Vectors and rotations between ode4j's types and ours. */
final class OdeVectors {

    private OdeVectors() {}

    static Vector3 from(DVector3C vector) {
        return new Vector3(vector.get0(), vector.get1(), vector.get2());
    }

    static RotationMatrix from(DMatrix3C m) {
        return new RotationMatrix(
                m.get00(), m.get01(), m.get02(), m.get10(), m.get11(), m.get12(), m.get20(), m.get21(), m.get22());
    }

    static DMatrix3 to(RotationMatrix r) {
        return new DMatrix3(r.xx(), r.xy(), r.xz(), r.yx(), r.yy(), r.yz(), r.zx(), r.zy(), r.zz());
    }
}
